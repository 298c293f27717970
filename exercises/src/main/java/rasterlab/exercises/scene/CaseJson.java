package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import java.util.List;
import rasterlab.exercises.scene.MethodCase.Pixel;

/** Cases as JSON. */
final class CaseJson {
    private CaseJson() {}

    static MethodCase read(Place file) {
        file.object("version", "topic", "method", "input", "drawn");
        file.at("version").integer(SceneFile.VERSION, SceneFile.VERSION);
        return new MethodCase(
                file.at("topic").text(),
                file.optional("method").map(Place::text),
                file.at("input").json(),
                file.optional("drawn").map(CaseJson::pixels));
    }

    private static List<Pixel> pixels(Place drawn) {
        List<Place> members = drawn.members();
        if (members.size() > MethodCase.MOST_DRAWN)
            throw drawn.wrong(
                    "must have at most %d pixels, got %d"
                            .formatted(MethodCase.MOST_DRAWN, members.size()));
        return members.stream().map(CaseJson::pixel).toList();
    }

    private static Pixel pixel(Place one) {
        List<Place> members = one.members();
        if (members.size() != 2)
            throw one.wrong("must be a pixel [x, y], got %d members".formatted(members.size()));
        return new Pixel(coordinate(members.get(0)), coordinate(members.get(1)));
    }

    private static int coordinate(Place one) {
        return one.integer(Integer.MIN_VALUE, Integer.MAX_VALUE);
    }

    static String write(MethodCase one) {
        ObjectNode file = Place.MAPPER.createObjectNode().put("version", SceneFile.VERSION);
        file.put("topic", one.topic());
        one.method().ifPresent(method -> file.put("method", method));
        file.putRawValue("input", new RawValue(one.input()));
        one.drawn().ifPresent(pixels -> write(pixels, file.putArray("drawn")));
        return file.toString();
    }

    private static void write(List<Pixel> pixels, ArrayNode drawn) {
        for (Pixel one : pixels) drawn.addArray().add(one.x()).add(one.y());
    }
}
