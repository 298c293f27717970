package rasterlab.app.canvas.lab;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.StrictJson;

/**
 * An input from elsewhere, such as an exercise, in a lab whose choices name hazards: it stands
 * there as a hazard whose name is the input itself, in JSON.
 */
public final class GivenInput {
    private GivenInput() {}

    /** Whether the name is no hazard's but an input. */
    public static boolean is(String name) {
        return name.startsWith("{");
    }

    /** The name that an input has in the place of a hazard's. */
    public static <I> String name(Topic<?, I, ?> topic, I input) {
        return CommandInput.signed(topic.format(), input);
    }

    /** The hazard of that name: one of the topic's, or the input that the name is. */
    public static <I> Hazard<I> hazard(Topic<?, I, ?> topic, String name) {
        return is(name)
                ? new Hazard<>(name, read(topic.format(), name), Map.of())
                : Named.find("hazard", name, topic.hazards(), Hazard::name);
    }

    /** The hazard of that name, where the type of the inputs does not matter. */
    public static Hazard<?> any(Topic<?, ?, ?> topic, String name) {
        return hazard(topic, name);
    }

    /** The sentence in place of a hazard's explanation. */
    public static String sentence(Language language) {
        return Texts.of("canvas", language).text("hazard.given");
    }

    /**
     * Makes an input from JSON as the command line does.
     *
     * @throws IllegalArgumentException naming the place that cannot be read
     */
    public static <I> I read(Format<?, I, ?> format, String json) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        try {
            return format.read(StrictJson.read(text, text.length, format.input(), format.open()));
        } catch (InvalidInput invalid) {
            throw new IllegalArgumentException(invalid.getMessage(), invalid);
        }
    }
}
