package rasterlab.exercises.judging;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.score.Message;

/** The run of a row in which a filling method puts a pixel, or why it puts it in none. */
final class AreaDecision {
    static final Map<String, Decision> BY_TOPIC =
            Map.of(
                    "fill", Decision.onPixel((input, right, one) -> onFill(input, one)),
                    "polygon-fill", Decision.onPixel((input, right, one) -> onPolygon(input, one)));

    private AreaDecision() {}

    static Message onFill(JsonNode input, Pixel at) {
        List<JsonNode> steps = Walk.of("fill", "span", input.toString()).steps();
        Optional<JsonNode> run =
                ofRow(steps, at).stream().filter(one -> holds(one, at)).findFirst();
        if (run.isPresent())
            return Decisions.message(
                    "fill",
                    "run",
                    at.y(),
                    run.get().path("from").asInt(),
                    run.get().path("to").asInt() - 1,
                    run.get().path("decision").asInt());
        int seed =
                at(input, input.path("seed").path(0).asInt(), input.path("seed").path(1).asInt());
        if (seed == input.path("with").asText().codePointAt(0)) return Message.NONE;
        return Decisions.message("fill", at(input, at.x(), at.y()) == seed ? "apart" : "wall", at);
    }

    /** The character of a pixel; −1 beside the picture. */
    private static int at(JsonNode input, int x, int y) {
        int[] row = input.path("picture").path(y).asText().codePoints().toArray();
        return x >= 0 && x < row.length ? row[x] : -1;
    }

    static Message onPolygon(JsonNode input, Pixel at) {
        List<JsonNode> steps = Walk.of("polygon-fill", "scanline", input.toString()).steps();
        List<JsonNode> runs = ofRow(steps, at);
        if (runs.isEmpty()) return Decisions.message("polygon-fill", "empty", at.y());
        return Decisions.message(
                "polygon-fill",
                "runs",
                at.y(),
                runs.get(0).path("decision").asInt(),
                runs.stream().map(AreaDecision::columns).collect(joining(", ")));
    }

    private static String columns(JsonNode run) {
        int from = run.path("from").asInt();
        int last = run.path("to").asInt() - 1;
        return last == from ? String.valueOf(from) : from + "–" + last;
    }

    private static List<JsonNode> ofRow(List<JsonNode> steps, Pixel at) {
        return steps.stream().filter(one -> one.path("y").asInt() == at.y()).toList();
    }

    private static boolean holds(JsonNode run, Pixel at) {
        return run.path("from").asInt() <= at.x() && at.x() < run.path("to").asInt();
    }
}
