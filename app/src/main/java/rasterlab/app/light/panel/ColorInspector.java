package rasterlab.app.light.panel;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.JLabel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.app.light.ColorChoice;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.OwnTrips;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.study.Method;

/** One colour on the sliders of all models, and how it comes back from each. */
final class ColorInspector {
    private static final int NOTCHES = 255;

    private final LightLabModel model;
    private final Texts texts;
    private final Texts explanations;
    private final Inspector column;
    private final ModeRow mode;
    private final List<Row> rows = new ArrayList<>();
    private NameChooser method;
    private final Map<ColorModel, JLabel> errors = new EnumMap<>(ColorModel.class);
    private final JLabel hex;
    private AboutText about;

    private record Row(ColorModel model, int index, NumberSlider slider) {}

    ColorInspector(LightLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        explanations = TopicTexts.of("color", texts.language()).texts();
        column = new Inspector(texts);
        mode = new ModeRow(model, texts, column);
        hex = column.value("hex");
    }

    /**
     * The sections that the constructor leaves out, in the column's order, as {@link
     * LabPanel#parts}.
     */
    List<Runnable> sections() {
        return List.of(this::addModels, this::addTrip, this::addAbout);
    }

    private void addModels() {
        for (ColorModel each : ColorModel.values()) {
            column.heading("model." + each.code());
            for (int i = 0; i < each.size(); i++) slider(each, i);
        }
    }

    private void addTrip() {
        column.heading("heading.trip");
        var methods =
                new ArrayList<>(new ColorTopic().methods().stream().map(Method::name).toList());
        methods.add(OwnMethods.NAME);
        method =
                new NameChooser(
                        "colourMethod",
                        methods,
                        name -> OwnWords.called(name, texts.language()),
                        name -> model.color(color -> color.withMethod(name)));
        column.row("colourMethod", method);
        for (ColorModel each : ColorModel.values())
            if (each != ColorModel.RGB) errors.put(each, column.value("trip." + each.code()));
    }

    private void addAbout() {
        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private void slider(ColorModel of, int index) {
        String key = of.code() + "." + of.component(index);
        var slider =
                new NumberSlider(
                        key,
                        texts.text(
                                "slider.hint", of.code().toUpperCase(Locale.ROOT), texts.text(key)),
                        0,
                        of.highest(index),
                        false,
                        NOTCHES,
                        value -> model.color(color -> color.with(of, index, value)));
        column.row(key, slider);
        rows.add(new Row(of, index, slider));
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        mode.refresh();
        ColorChoice color = model.state().color();
        hex.setText(
                String.format(Locale.ROOT, "#%06X", color.rgb())
                        + (color.outside() ? "   " + texts.text("outside") : ""));
        for (Row row : rows) {
            double value = color.in(row.model())[row.index()];
            boolean hue = row.model().isHue(row.index());
            String said =
                    Double.isNaN(value) ? "–" : Shown.number(value, hue ? 0 : 3, texts.locale());
            row.slider()
                    .show(
                            Double.isNaN(value) ? 0 : value,
                            hue && !Double.isNaN(value) ? said + "°" : said);
        }
        method.show(color.method());
        boolean own = color.method().equals(OwnMethods.NAME);
        Optional<OwnTrips.Trips> mine = own ? model.ownTrips(color) : Optional.empty();
        Map<ColorModel, Double> known =
                own ? mine.map(OwnTrips.Trips::errors).orElse(Map.of()) : color.roundTrips();
        errors.forEach(
                (each, label) ->
                        label.setText(known.containsKey(each) ? error(known.get(each)) : "—"));
        about.show(
                explanations,
                color.method(),
                "",
                mine.map(one -> one.refusalIn(texts.language())).orElse(""));
    }

    private String error(double error) {
        if (Double.isNaN(error)) return texts.text("trip.none");
        return error == 0 ? texts.text("trip.exact") : Shown.number(error, 6, texts.locale());
    }
}
