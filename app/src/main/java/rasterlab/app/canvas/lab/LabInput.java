package rasterlab.app.canvas.lab;

import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.method.TopicColors;

/**
 * The part of a lab's state that its hazards need to know.
 *
 * @param input the present one, with {@code equals}
 * @param method name of the chosen method; "" where none is judged
 * @param choose chooses another method
 * @param colors of the methods
 * @param called what the lab calls a method of that name
 * @param unjudged a sentence that says why no method is judged by some hazards; "" where all judge
 */
public record LabInput(
        Supplier<?> input,
        Supplier<String> method,
        Consumer<String> choose,
        TopicColors colors,
        UnaryOperator<String> called,
        String unjudged) {
    public LabInput(
            Supplier<?> input,
            Supplier<String> method,
            Consumer<String> choose,
            TopicColors colors) {
        this(input, method, choose, colors, name -> name, "");
    }

    /**
     * Describes a lab whose scenes judge no method.
     *
     * @param why one sentence
     */
    public static LabInput unjudged(Supplier<?> input, String why) {
        return new LabInput(
                input, () -> "", method -> {}, new TopicColors(Map.of()), name -> name, why);
    }
}
