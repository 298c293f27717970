package rasterlab.app.spline;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.language.Texts;

/** The controls that both labs' inspectors have. */
final class InspectorParts {
    private final Inspector column;
    private final Texts texts;

    InspectorParts(Inspector column, Texts texts) {
        this.column = column;
        this.texts = texts;
    }

    /** Leads to the other lab; in this one it always shows this one's name. */
    void mode(SplineMode own, Consumer<SplineMode> chosen) {
        var chooser = new NameChooser[1];
        chooser[0] =
                names(
                        "mode",
                        Stream.of(SplineMode.values()).map(SplineMode::code).toList(),
                        code -> {
                            chooser[0].show(own.code());
                            chosen.accept(SplineMode.named(code));
                        });
        chooser[0].show(own.code());
    }

    /** A list of names, each said as {@code KEY.NAME}. */
    NameChooser names(String key, List<String> names, Consumer<String> chosen) {
        var chooser = new NameChooser(key, names, name -> texts.text(key + "." + name), chosen);
        column.row(key, chooser);
        return chooser;
    }

    NumberSlider slider(
            String key,
            double least,
            double most,
            boolean logarithmic,
            int notches,
            DoubleConsumer changed) {
        var slider =
                new NumberSlider(
                        key, texts.text(key + ".hint"), least, most, logarithmic, notches, changed);
        column.row(key, slider);
        return slider;
    }

    /** A check box that is not placed yet. */
    JCheckBox box(String key, Consumer<Boolean> chosen) {
        return KeyedControls.box(key, texts, chosen);
    }
}
