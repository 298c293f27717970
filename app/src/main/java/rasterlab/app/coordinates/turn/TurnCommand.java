package rasterlab.app.coordinates.turn;

import rasterlab.app.coordinates.figure.CallJson;

/** The shell command that turns what the lab turns. */
final class TurnCommand {
    private TurnCommand() {}

    static String of(TurnChoice choice) {
        return "echo '{\"points\": %s, \"degrees\": %s, \"times\": %d}' | ./lab run rotate %s"
                .formatted(
                        CallJson.points(2, new double[] {choice.x(), choice.y()}),
                        CallJson.number(choice.degrees()),
                        choice.times(),
                        choice.method());
    }
}
