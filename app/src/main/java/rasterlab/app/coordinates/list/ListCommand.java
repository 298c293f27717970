package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import rasterlab.app.coordinates.figure.CallJson;

/** The shell command that computes the images which the lab shows. */
final class ListCommand {
    private ListCommand() {}

    /** What is shown of a trial, or of the steps that are done. */
    static String of(ListLabModel model) {
        return model.shownTrial()
                .flatMap(shown -> model.choice().trial())
                .map(model.trials()::command)
                .orElseGet(() -> of(model.scene(), model.step()));
    }

    /** Named matrices by their right formula are named, others are given by their cells. */
    static String of(ListScene scene, int step) {
        ListChoice choice = scene.choice();
        int size = choice.items().size();
        int from = choice.reading() == Reading.OBJECTS ? size - Math.min(step, size) : 0;
        int to = choice.reading() == Reading.OBJECTS ? size : Math.min(step, size);
        var applied = new ArrayList<String>();
        for (int i = from; i < to; i++) applied.add(matrix(scene, i));
        Collections.reverse(applied);
        return "echo '{\"matrices\": %s, \"points\": %s}' | ./lab run transform double"
                .formatted(
                        applied.stream().collect(Collectors.joining(", ", "[", "]")),
                        CallJson.points(choice.dimension(), choice.wire().numbers()));
    }

    private static String matrix(ListScene scene, int index) {
        List<ListItem> items = scene.choice().items();
        boolean named = !items.get(index).free() && scene.choice().method().equals("formula");
        return named || scene.isRefused() && !items.get(index).free()
                ? CallJson.call(items.get(index).call())
                : CallJson.rows(scene.choice().dimension() + 1, cells(scene, index));
    }

    private static double[] cells(ListScene scene, int index) {
        return scene.isRefused()
                ? scene.choice().items().get(index).numbers().stream()
                        .mapToDouble(Double::doubleValue)
                        .toArray()
                : scene.cells().get(index);
    }
}
