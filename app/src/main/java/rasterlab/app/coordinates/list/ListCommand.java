package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import rasterlab.app.coordinates.figure.ChainCommand;
import rasterlab.engine.format.Written;

/** The shell command that computes the images which the lab shows. */
final class ListCommand {
    private ListCommand() {}

    /** The command for the trial that is shown, or for the steps that are done. */
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
        var applied = new ArrayList<Written>();
        for (int i = from; i < to; i++) applied.add(matrix(scene, i));
        Collections.reverse(applied);
        return ChainCommand.of(applied, choice.dimension(), choice.wire().numbers(), "double");
    }

    private static Written matrix(ListScene scene, int index) {
        List<ListItem> items = scene.choice().items();
        boolean named = !items.get(index).free() && scene.choice().method().equals("formula");
        return named || scene.isRefused() && !items.get(index).free()
                ? ChainCommand.named(items.get(index).call())
                : ChainCommand.cells(scene.choice().dimension() + 1, cells(scene, index));
    }

    private static double[] cells(ListScene scene, int index) {
        return scene.isRefused()
                ? scene.choice().items().get(index).numbers().stream()
                        .mapToDouble(Double::doubleValue)
                        .toArray()
                : scene.cells().get(index);
    }
}
