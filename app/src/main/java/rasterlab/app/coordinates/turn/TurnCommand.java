package rasterlab.app.coordinates.turn;

import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.rotate.Turns;

/** The shell command that turns what the lab turns. */
final class TurnCommand {
    private TurnCommand() {}

    static String of(TurnChoice choice) {
        double[] point = {choice.x(), choice.y()};
        var turns = new Turns(choice.degrees(), choice.times(), point);
        return "echo '%s' | ./lab run rotate %s"
                .formatted(
                        CommandInput.of(new RotateTopic().format(), turns),
                        OwnWords.known(choice.method(), "total-angle", "rotate"));
    }
}
