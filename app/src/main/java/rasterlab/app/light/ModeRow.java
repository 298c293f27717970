package rasterlab.app.light;

import java.util.List;
import rasterlab.app.canvas.Inspector;
import rasterlab.app.canvas.NameChooser;
import rasterlab.app.language.Texts;

/** The choice between light and colour models, first in both columns. */
final class ModeRow {
    private static final String LIGHT = "light";
    private static final String COLOURS = "colours";

    private final LightLabModel model;
    private final NameChooser mode;

    ModeRow(LightLabModel model, Texts texts, Inspector column) {
        this.model = model;
        mode =
                new NameChooser(
                        "mode",
                        List.of(LIGHT, COLOURS),
                        code -> texts.text("mode." + code),
                        code -> model.showColours(code.equals(COLOURS)));
        column.row("mode", mode);
    }

    void refresh() {
        mode.show(model.state().colours() ? COLOURS : LIGHT);
    }
}
