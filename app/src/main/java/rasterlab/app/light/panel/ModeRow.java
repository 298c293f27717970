package rasterlab.app.light.panel;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightLabModel;

/** The choice between light, colour models and rows of textures, first in each column. */
final class ModeRow {
    static final String LIGHT = "light";
    static final String COLORS = "colours";

    private final LightLabModel model;
    private final NameChooser mode;

    ModeRow(LightLabModel model, Texts texts, Inspector column) {
        this.model = model;
        mode =
                new NameChooser(
                        "mode",
                        names(model),
                        code -> TopicTexts.mode(texts, code),
                        code -> choose(model, code));
        column.row("mode", mode);
    }

    /** Light, colours, and the topics whose rows can be shown. */
    static List<String> names(LightLabModel model) {
        var names = new ArrayList<String>(List.of(LIGHT, COLORS));
        names.addAll(model.rows().topics());
        return names;
    }

    static void choose(LightLabModel model, String name) {
        if (model.rows().topics().contains(name)) {
            model.rows().open(name);
            return;
        }
        model.rows().close();
        model.showColors(name.equals(COLORS));
    }

    void refresh() {
        mode.show(model.state().colors() ? COLORS : LIGHT);
    }
}
