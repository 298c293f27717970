package rasterlab.exercises.scene;

import java.util.Optional;

/**
 * An input of a topic's methods, exactly as {@code ./lab run} takes it.
 *
 * @param topic such as "line"
 * @param method that was called; empty where it was a student's own
 * @param input a JSON object
 */
public record MethodCase(String topic, Optional<String> method, String input) implements SceneFile {
    public MethodCase {
        Place.root(input).object();
    }

    @Override
    public String write() {
        return CaseJson.write(this);
    }
}
