package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.scene.MethodCase.DrawnPixels;
import rasterlab.exercises.scene.MethodCase.PlottedPixel;
import rasterlab.exercises.scene.MethodCase.SearchFinding;

/** Cases as JSON. */
final class CaseJson {
    private CaseJson() {}

    static MethodCase read(SceneJsonPlace file) {
        file.object("version", "topic", "method", "input", "drawn", "drawnCut", "found");
        file.at("version").integer(SceneFile.VERSION, SceneFile.VERSION);
        return new MethodCase(
                file.at("topic").text(),
                file.optional("method").map(SceneJsonPlace::text),
                file.at("input").json(),
                drawn(file),
                file.optional("found").map(CaseJson::found));
    }

    private static SearchFinding found(SceneJsonPlace found) {
        found.object("verdict", "seed");
        return new SearchFinding(
                found.at("verdict").text(),
                found.at("seed").integer(Integer.MIN_VALUE, Integer.MAX_VALUE));
    }

    private static Optional<DrawnPixels> drawn(SceneJsonPlace file) {
        Optional<SceneJsonPlace> cut = file.optional("drawnCut");
        if (cut.isPresent() && !file.has("drawn"))
            throw cut.get().wrong("must stand beside \"drawn\", which there is not");
        return file.optional("drawn")
                .map(
                        pixels ->
                                new DrawnPixels(
                                        pixels(pixels),
                                        cut.map(SceneJsonPlace::flag).orElse(false)));
    }

    private static List<PlottedPixel> pixels(SceneJsonPlace drawn) {
        List<SceneJsonPlace> members = drawn.members();
        if (members.size() > MethodCase.MOST_DRAWN)
            throw drawn.wrong(
                    "must have at most %d pixels, got %d"
                            .formatted(MethodCase.MOST_DRAWN, members.size()));
        return members.stream().map(CaseJson::pixel).toList();
    }

    private static PlottedPixel pixel(SceneJsonPlace one) {
        List<SceneJsonPlace> members = one.members();
        if (members.size() != 2)
            throw one.wrong("must be a pixel [x, y], got %d members".formatted(members.size()));
        return new PlottedPixel(coordinate(members.get(0)), coordinate(members.get(1)));
    }

    private static int coordinate(SceneJsonPlace one) {
        return one.integer(Integer.MIN_VALUE, Integer.MAX_VALUE);
    }

    static String write(MethodCase one) {
        ObjectNode file = JsonNodeFactory.instance.objectNode().put("version", SceneFile.VERSION);
        file.put("topic", one.topic());
        one.method().ifPresent(method -> file.put("method", method));
        file.putRawValue("input", new RawValue(one.input()));
        one.drawn().ifPresent(drawn -> write(drawn, file));
        one.found()
                .ifPresent(
                        found ->
                                file.putObject("found")
                                        .put("verdict", found.verdict())
                                        .put("seed", found.seed()));
        return file.toString();
    }

    private static void write(DrawnPixels drawn, ObjectNode file) {
        ArrayNode pixels = file.putArray("drawn");
        for (PlottedPixel one : drawn.pixels()) pixels.addArray().add(one.x()).add(one.y());
        if (drawn.cut()) file.put("drawnCut", true);
    }
}
