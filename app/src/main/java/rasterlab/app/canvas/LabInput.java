package rasterlab.app.canvas;

import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * The part of a lab's state that its hazards need to know.
 *
 * @param input the present one, with {@code equals}
 * @param method name of the chosen method; "" where none is judged
 * @param choose chooses another method
 */
public record LabInput(Supplier<?> input, Supplier<String> method, Consumer<String> choose) {
    /** Describes a lab whose scenes judge no method. */
    public static LabInput unjudged(Supplier<?> input) {
        return new LabInput(input, () -> "", method -> {});
    }
}
