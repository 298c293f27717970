package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;

/** Cases as JSON. */
final class CaseJson {
    private CaseJson() {}

    static MethodCase read(Place file) {
        file.object("version", "topic", "method", "input");
        file.at("version").integer(SceneFile.VERSION, SceneFile.VERSION);
        return new MethodCase(
                file.at("topic").text(),
                file.optional("method").map(Place::text),
                file.at("input").json());
    }

    static String write(MethodCase one) {
        ObjectNode file = Place.MAPPER.createObjectNode().put("version", SceneFile.VERSION);
        file.put("topic", one.topic());
        one.method().ifPresent(method -> file.put("method", method));
        file.putRawValue("input", new RawValue(one.input()));
        return file.toString();
    }
}
