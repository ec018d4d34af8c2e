# External packages that only taut_scene uses.
