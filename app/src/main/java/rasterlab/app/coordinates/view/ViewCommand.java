package rasterlab.app.coordinates.view;

import java.util.List;
import rasterlab.app.coordinates.figure.ChainCommand;
import rasterlab.engine.format.Written;

/** The shell command that computes the coordinates which the lab shows. */
final class ViewCommand {
    private ViewCommand() {}

    static String of(ViewScene scene, int stage) {
        List<Written> matrices =
                scene.stages().subList(0, stage + 1).stream()
                        .flatMap(each -> each.calls().stream())
                        .map(ChainCommand::named)
                        .toList();
        return ChainCommand.of(matrices, 3, ViewScene.HOUSE.numbers(), scene.choice().method());
    }
}
