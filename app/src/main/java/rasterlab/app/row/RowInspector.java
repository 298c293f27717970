package rasterlab.app.row;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JLabel;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.coordinates.figure.NumberTable;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** The method, what is special about the row, the chosen pixel's numbers and the verdict. */
final class RowInspector {
    private static final String UNKNOWN = "—";
    private static final int DIGITS = 9;

    /** Number of digits where there are many columns. */
    private static final int FEWER = 7;

    private final RowLabModel model;
    private final Texts texts;
    private final Texts verdicts;
    private final Inspector column;
    private final NameChooser mode;
    private final List<MethodChooser> methods = new ArrayList<>();
    private final WrappedText description = new WrappedText("description");
    private final JLabel pixel;
    private final NumberTable numbers;
    private final JLabel verdict;
    private final JLabel wrong;
    private final AboutText about;

    /** The numbers that were shown last. */
    private RowScene.PixelNumbers read = new RowScene.PixelNumbers(List.of(), List.of());

    /**
     * @param modes of the tab, the labs' names in its texts
     * @param chosen told which the user wants
     */
    RowInspector(
            RowLabModel model,
            Texts texts,
            Texts modeTexts,
            List<String> modes,
            Consumer<String> chosen) {
        this.model = model;
        this.texts = texts;
        verdicts = Texts.of("study", texts.language());
        column = new Inspector(texts);
        mode = new NameChooser("mode", modes, code -> TopicTexts.mode(modeTexts, code), chosen);
        column.row("mode", mode);
        for (String topic : model.topics()) methods.add(methods(topic));
        column.heading("heading.row");
        column.wide(description);
        column.heading("heading.pixel");
        pixel = column.value("pixel");
        numbers = new NumberTable("numbers", texts.text("heading.pixel"));
        column.wide(numbers);
        column.heading("heading.result");
        verdict = column.value("verdict");
        wrong = column.value("wrong");
        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private MethodChooser methods(String topic) {
        List<String> names = model.methods(topic).stream().map(Method::name).toList();
        var chooser =
                new MethodChooser("method", "", names, RowColors.OWN, model::chooseMethod)
                        .withOwn(Texts.of("canvas", texts.language()));
        column.row("method", chooser);
        return chooser;
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        RowChoice choice = model.choice();
        mode.show(choice.topic());
        for (int i = 0; i < methods.size(); i++) {
            boolean shown = model.topics().get(i).equals(choice.topic());
            column.showRow(methods.get(i), shown);
            if (shown) methods.get(i).show(choice.method());
        }
        TopicTexts said = TopicTexts.of(choice.topic(), texts.language());
        description.show(
                GivenInput.is(choice.hazard())
                        ? GivenInput.sentence(texts.language())
                        : said.hazard(choice.hazard()));
        pixel.setText(texts.text("pixel.number", choice.pixel(), model.pixels() - 1));
        model.shown().ifPresentOrElse(this::show, this::showNothing);
        about.show(said.texts(), choice.method(), "", "");
    }

    private void show(RowScene scene) {
        read = scene.numbers().apply(model.choice().pixel());
        showNumbers(this::line);
        verdict.setText(verdicts.text("verdict." + scene.verdict().kind().code()));
        wrong.setText(
                scene.errors().length == 0
                        ? UNKNOWN
                        : texts.text("pixel.of", scene.wrongPixels(), scene.pixels()));
    }

    /** Nothing is said of a scene that is not there; the table keeps its size meanwhile. */
    private void showNothing() {
        showNumbers(RowInspector::unknown);
        verdict.setText(UNKNOWN);
        wrong.setText(UNKNOWN);
    }

    private void showNumbers(Function<RowScene.NumberRow, List<String>> cells) {
        numbers.show(
                read.headings().stream().map(key -> texts.text("column." + key)).toList(),
                read.lines().stream().map(cells).toList(),
                -1);
    }

    private static List<String> unknown(RowScene.NumberRow line) {
        var cells = new ArrayList<>(Collections.nCopies(line.values().length + 1, UNKNOWN));
        cells.set(0, line.name());
        return cells;
    }

    private List<String> line(RowScene.NumberRow line) {
        var cells = new ArrayList<String>();
        cells.add(line.name());
        int digits = line.values().length < 3 ? DIGITS : FEWER;
        for (double value : line.values()) cells.add(number(value, digits));
        return cells;
    }

    /** The number with as many digits as tell apart what a format does. */
    private String number(double value, int digits) {
        String text = String.format(Locale.ROOT, "%." + digits + "g", value);
        if (value == Math.rint(value) && Math.abs(value) < 1e10)
            text = String.format(Locale.ROOT, "%.0f", value);
        if (!text.contains("e") && text.contains(".")) text = text.replaceFirst("\\.?0+$", "");
        return texts.locale().getLanguage().equals("ru") ? text.replace('.', ',') : text;
    }
}
