package rasterlab.app.coordinates.figure;

import java.util.function.Consumer;
import java.util.stream.Stream;
import rasterlab.app.canvas.Inspector;
import rasterlab.app.canvas.LabPanel;
import rasterlab.app.canvas.NameChooser;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** One of the tab's labs, in one language. */
public abstract class LabCard extends LabPanel {
    private static final long serialVersionUID = 1L;

    /** Stops playing, for the lab is not seen any more. */
    public abstract void stop();

    /** A row that leads to the other labs; in this one it always shows this one's name. */
    protected static void modeRow(
            Inspector column,
            CoordinatesMode own,
            Language language,
            Consumer<CoordinatesMode> chosen) {
        Texts texts = Texts.of("coordinates", language);
        var chooser = new NameChooser[1];
        chooser[0] =
                new NameChooser(
                        "mode",
                        Stream.of(CoordinatesMode.values()).map(CoordinatesMode::code).toList(),
                        code -> texts.text("mode." + code),
                        code -> {
                            chooser[0].show(own.code());
                            chosen.accept(CoordinatesMode.named(code));
                        });
        chooser[0].show(own.code());
        column.row("mode", chooser[0]);
    }
}
