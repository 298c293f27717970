package rasterlab.app.light.panel;

import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.light.ColorChoice;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.color.Colors;

/** The shell command that writes the colour in all models. */
final class ColorCommand {
    private ColorCommand() {}

    static String of(ColorChoice choice) {
        Colors color = Colors.of(choice.model(), choice.in(choice.model()));
        return "echo '%s' | ./lab run color %s"
                .formatted(
                        CommandInput.of(new ColorTopic().format(), color),
                        OwnWords.known(choice.method(), "formula", "color"));
    }
}
