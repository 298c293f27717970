package rasterlab.app.line;

import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.engine.line.LineTopic;

/** The shell command that draws what the lab shows. */
final class LineCommand {
    private LineCommand() {}

    static String of(LineChoice choice) {
        return "echo '%s' | ./lab run line %s"
                .formatted(
                        CommandInput.of(new LineTopic().format(), choice.segment()),
                        OwnWords.known(choice.method(), choice.comparison(), "line"));
    }
}
