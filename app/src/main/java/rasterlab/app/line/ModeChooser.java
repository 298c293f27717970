package rasterlab.app.line;

import java.util.stream.Stream;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineMode;

/** The list of what the lab draws. */
final class ModeChooser {
    private ModeChooser() {}

    /**
     * @param shown what it shows first
     */
    static NameChooser of(LineMode shown, LineLabModel model, Texts texts) {
        var chooser = new NameChooser[1];
        chooser[0] =
                new NameChooser(
                        "mode",
                        Stream.of(LineMode.values()).map(LineMode::code).toList(),
                        code -> texts.text("mode." + code),
                        code -> {
                            // The list in this figure's panel keeps naming what the panel shows.
                            if (shown == LineMode.SEGMENT) chooser[0].show(shown.code());
                            model.chooseMode(LineMode.coded(code));
                        });
        chooser[0].show(shown.code());
        return chooser[0];
    }
}
