#pragma once

#include <GL/glcorearb.h>

#include "render/gl_context.h"

namespace taut {

/// Finds functions in a context. What it returns turns into whatever function type it is stored as. Throws
/// RunFailure for a function that the context lacks.
class GlLoader {
 public:
  class Found {
   public:
    explicit Found(GlContext::Function function) : function_(function) {}
    template <typename Wanted>
    operator Wanted() const {
      return reinterpret_cast<Wanted>(function_);
    }

   private:
    GlContext::Function function_;
  };

  explicit GlLoader(const GlContext& context) : context_(context) {}
  Found operator()(const char* name) const;

 private:
  const GlContext& context_;
};

/// The OpenGL functions that this program uses, of one context (which must be current).
class Gl {
 private:
  GlLoader load;  // first: the members below are initialised through it

 public:
  explicit Gl(const GlContext& context) : load(context) {}

  PFNGLENABLEPROC enable = load("glEnable");
  PFNGLDISABLEPROC disable = load("glDisable");
  PFNGLGETINTEGERVPROC get_integers = load("glGetIntegerv");
  PFNGLGETSTRINGPROC get_string = load("glGetString");
  PFNGLGETERRORPROC get_error = load("glGetError");

  PFNGLBLENDFUNCSEPARATEPROC blend_function = load("glBlendFuncSeparate");
  PFNGLCOLORMASKPROC colour_mask = load("glColorMask");
  PFNGLVIEWPORTPROC viewport = load("glViewport");
  PFNGLSCISSORPROC scissor = load("glScissor");
  PFNGLCLEARCOLORPROC clear_colour = load("glClearColor");
  PFNGLCLEARPROC clear = load("glClear");
  PFNGLDEPTHFUNCPROC depth_function = load("glDepthFunc");
  PFNGLFRONTFACEPROC front_face = load("glFrontFace");
  PFNGLPOLYGONOFFSETPROC polygon_offset = load("glPolygonOffset");
  PFNGLPIXELSTOREIPROC pixel_store = load("glPixelStorei");
  PFNGLREADPIXELSPROC read_pixels = load("glReadPixels");

  PFNGLFLUSHPROC flush = load("glFlush");
  PFNGLFENCESYNCPROC fence = load("glFenceSync");
  PFNGLCLIENTWAITSYNCPROC wait_for_fence = load("glClientWaitSync");
  PFNGLDELETESYNCPROC delete_fence = load("glDeleteSync");

  PFNGLGENBUFFERSPROC make_buffers = load("glGenBuffers");
  PFNGLDELETEBUFFERSPROC delete_buffers = load("glDeleteBuffers");
  PFNGLBINDBUFFERPROC bind_buffer = load("glBindBuffer");
  PFNGLBINDBUFFERBASEPROC bind_buffer_base = load("glBindBufferBase");
  PFNGLBUFFERDATAPROC buffer_data = load("glBufferData");

  PFNGLGENVERTEXARRAYSPROC make_vertex_arrays = load("glGenVertexArrays");
  PFNGLDELETEVERTEXARRAYSPROC delete_vertex_arrays = load("glDeleteVertexArrays");
  PFNGLBINDVERTEXARRAYPROC bind_vertex_array = load("glBindVertexArray");
  PFNGLENABLEVERTEXATTRIBARRAYPROC enable_attribute = load("glEnableVertexAttribArray");
  PFNGLVERTEXATTRIBPOINTERPROC attribute_pointer = load("glVertexAttribPointer");
  PFNGLVERTEXATTRIBDIVISORPROC attribute_divisor = load("glVertexAttribDivisor");
  PFNGLDRAWARRAYSPROC draw_arrays = load("glDrawArrays");
  PFNGLDRAWARRAYSINSTANCEDPROC draw_arrays_instanced = load("glDrawArraysInstanced");
  PFNGLDRAWELEMENTSPROC draw_elements = load("glDrawElements");
  PFNGLDRAWELEMENTSINSTANCEDPROC draw_elements_instanced = load("glDrawElementsInstanced");

  PFNGLGENTEXTURESPROC make_textures = load("glGenTextures");
  PFNGLDELETETEXTURESPROC delete_textures = load("glDeleteTextures");
  PFNGLBINDTEXTUREPROC bind_texture = load("glBindTexture");
  PFNGLACTIVETEXTUREPROC active_texture = load("glActiveTexture");
  PFNGLTEXIMAGE2DPROC texture_image = load("glTexImage2D");
  PFNGLTEXPARAMETERIPROC texture_parameter = load("glTexParameteri");
  PFNGLTEXPARAMETERFVPROC texture_parameters = load("glTexParameterfv");
  PFNGLGENERATEMIPMAPPROC make_mipmap = load("glGenerateMipmap");

  PFNGLGENFRAMEBUFFERSPROC make_framebuffers = load("glGenFramebuffers");
  PFNGLDELETEFRAMEBUFFERSPROC delete_framebuffers = load("glDeleteFramebuffers");
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = load("glBindFramebuffer");
  PFNGLFRAMEBUFFERTEXTURE2DPROC framebuffer_texture = load("glFramebufferTexture2D");
  PFNGLFRAMEBUFFERRENDERBUFFERPROC framebuffer_renderbuffer = load("glFramebufferRenderbuffer");
  PFNGLCHECKFRAMEBUFFERSTATUSPROC framebuffer_status = load("glCheckFramebufferStatus");
  PFNGLBLITFRAMEBUFFERPROC blit_framebuffer = load("glBlitFramebuffer");
  PFNGLDRAWBUFFERPROC draw_buffer = load("glDrawBuffer");
  PFNGLREADBUFFERPROC read_buffer = load("glReadBuffer");
  PFNGLGENRENDERBUFFERSPROC make_renderbuffers = load("glGenRenderbuffers");
  PFNGLDELETERENDERBUFFERSPROC delete_renderbuffers = load("glDeleteRenderbuffers");
  PFNGLBINDRENDERBUFFERPROC bind_renderbuffer = load("glBindRenderbuffer");
  PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC renderbuffer_storage = load("glRenderbufferStorageMultisample");

  PFNGLCREATESHADERPROC create_shader = load("glCreateShader");
  PFNGLDELETESHADERPROC delete_shader = load("glDeleteShader");
  PFNGLSHADERSOURCEPROC shader_source = load("glShaderSource");
  PFNGLCOMPILESHADERPROC compile_shader = load("glCompileShader");
  PFNGLGETSHADERIVPROC get_shader = load("glGetShaderiv");
  PFNGLGETSHADERINFOLOGPROC get_shader_log = load("glGetShaderInfoLog");
  PFNGLCREATEPROGRAMPROC create_program = load("glCreateProgram");
  PFNGLDELETEPROGRAMPROC delete_program = load("glDeleteProgram");
  PFNGLATTACHSHADERPROC attach_shader = load("glAttachShader");
  PFNGLLINKPROGRAMPROC link_program = load("glLinkProgram");
  PFNGLGETPROGRAMIVPROC get_program = load("glGetProgramiv");
  PFNGLGETPROGRAMINFOLOGPROC get_program_log = load("glGetProgramInfoLog");
  PFNGLUSEPROGRAMPROC use_program = load("glUseProgram");
  PFNGLGETUNIFORMLOCATIONPROC uniform_location = load("glGetUniformLocation");
  PFNGLUNIFORM1IPROC set_integer = load("glUniform1i");
  PFNGLUNIFORM3FPROC set_vector = load("glUniform3f");
  PFNGLGETUNIFORMBLOCKINDEXPROC uniform_block_index = load("glGetUniformBlockIndex");
  PFNGLUNIFORMBLOCKBINDINGPROC uniform_block_binding = load("glUniformBlockBinding");
};

/// Throws RunFailure, naming `doing`, when OpenGL has reported an error since it was last asked.
void check_gl(const Gl& gl, const char* doing);

}  // namespace taut
