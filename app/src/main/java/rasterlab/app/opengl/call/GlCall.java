package rasterlab.app.opengl.call;

import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.opengl.state.Setting;

/**
 * One call, or a run of calls for the vertices of a shape.
 *
 * @param setting the state that it sets; empty where no control does
 * @param text as a program in C has it
 * @param action makes the call in the current context
 */
public record GlCall(Optional<Setting> setting, String text, Consumer<GlObjects> action) {}
