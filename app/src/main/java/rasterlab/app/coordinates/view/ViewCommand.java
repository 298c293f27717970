package rasterlab.app.coordinates.view;

import java.util.stream.Collectors;
import rasterlab.app.coordinates.figure.CallJson;

/** The shell command that computes the coordinates which the lab shows. */
final class ViewCommand {
    private ViewCommand() {}

    static String of(ViewScene scene, int stage) {
        String matrices =
                scene.stages().subList(0, stage + 1).stream()
                        .flatMap(each -> each.calls().stream())
                        .map(CallJson::call)
                        .collect(Collectors.joining(", ", "[", "]"));
        return "echo '{\"matrices\": %s, \"points\": %s}' | ./lab run transform %s"
                .formatted(
                        matrices,
                        CallJson.points(3, ViewScene.HOUSE.numbers()),
                        scene.choice().method());
    }
}
