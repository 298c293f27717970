package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.app.coordinates.figure.MatrixFormulas;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.matrix.MatrixParameter;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/** The state of the lab in words, numbers and formulas of one language. */
final class ListReadings {
    private final ListLabModel model;
    private final ListScene scene;
    private final Texts texts;
    private final Locale locale;

    ListReadings(ListLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        scene = model.scene();
        locale = texts.locale();
    }

    /** One item as the list shows it. */
    static String item(ListItem item, int number, Texts texts) {
        String said =
                item.free()
                        ? texts.text("matrix.free")
                        : MatrixFormulas.callText(item.call(), texts.locale());
        return number + ". " + said;
    }

    /** Why an item is refused: in the engine's words where those are the window's language. */
    static String refusal(ListScene scene, Texts texts) {
        String item = item(scene.choice().items().get(scene.refused()), scene.refused() + 1, texts);
        return texts.text(
                "note.refused",
                item,
                texts.language() == Language.ENGLISH
                        ? scene.refusal()
                        : allowed(scene.choice().items().get(scene.refused()), texts));
    }

    /** The first parameter that is out of its range, and the range. */
    private static String allowed(ListItem item, Texts texts) {
        if (item.free()) return texts.text("range.large");
        int next = 0;
        for (MatrixParameter parameter : NamedMatrices.named(item.name()).parameters())
            for (int i = 0; i < parameter.size(); i++, next++)
                try {
                    parameter.require(item.numbers().get(next), i);
                } catch (IllegalArgumentException outside) {
                    return parameter.name()
                            + ": "
                            + texts.text("range." + parameter.range().name())
                            + " ("
                            + Shown.number(item.numbers().get(next), texts.locale())
                            + ")";
                }
        return texts.text("range.large");
    }

    String done() {
        if (scene.isRefused()) return "—";
        int newest = scene.newest(model.step());
        if (model.step() == 0) return texts.text("done.none");
        return item(model.choice().items().get(newest), newest + 1, texts);
    }

    String meaning(Texts explanations) {
        if (selected().isEmpty()) return "—";
        ListItem item = selected().get();
        if (item.free()) return texts.text("matrix.free.meaning");
        NamedMatrix matrix = NamedMatrices.named(item.name());
        return explanations.textOr("matrix." + matrix.name(), matrix.meaning());
    }

    String error() {
        return model.deviation()
                .map(
                        found ->
                                model.correct(found)
                                        ? texts.text("error.none")
                                        : texts.text(
                                                "error.wrong",
                                                Shown.number(found.worst(), 3, locale)))
                .orElse("—");
    }

    private Optional<ListItem> selected() {
        int index = model.choice().selected();
        return index < 0 ? Optional.empty() : Optional.of(model.choice().items().get(index));
    }

    /** The selected matrix and its inverse, then the product of all that is done. */
    List<Formula> formulas() {
        var lines = new ArrayList<Formula>();
        if (selected().isEmpty() || scene.isRefused()) return lines;
        int index = model.choice().selected();
        lines.add(
                MatrixFormulas.named(
                        "M" + low(index + 1) + " =", scene.cells().get(index), locale));
        inverse(selected().get(), index).ifPresent(lines::add);
        lines.add(Formula.of(new Formula.FormulaWords(texts.text("product"))));
        List<double[]> applied = scene.applied(model.step(), false);
        lines.add(MatrixFormulas.named(order() + " =", product(applied), locale));
        return lines;
    }

    private Optional<Formula> inverse(ListItem item, int index) {
        if (item.free()) return Optional.empty();
        double[] numbers = item.numbers().stream().mapToDouble(Double::doubleValue).toArray();
        return NamedMatrices.named(item.name())
                .inverseRows(numbers)
                .map(
                        rows ->
                                MatrixFormulas.named(
                                        "M" + low(index + 1) + "⁻¹ =", Chains.flat(rows), locale));
    }

    /** {@code p · M3 · M2 · M1} for what is done. */
    private String order() {
        var order = new StringBuilder("p");
        int size = model.choice().items().size();
        int step = model.step();
        boolean objects = model.choice().reading() == Reading.OBJECTS;
        for (int i = 0; i < step; i++)
            order.append("·M").append(low(objects ? size - i : step - i));
        return order.toString();
    }

    private static String low(int number) {
        var low = new StringBuilder();
        for (char digit : String.valueOf(number).toCharArray())
            low.append((char) ('₀' + digit - '0'));
        return low.toString();
    }

    /** The rows of the product are the images of the unit rows. */
    private double[] product(List<double[]> cells) {
        return Chains.product(model.choice().dimension() + 1, cells);
    }

    List<String> headings() {
        return model.choice().dimension() == 2
                ? List.of("№", "x", "y", "x′", "y′", "H")
                : List.of("№", "x", "y", "z", "x′", "y′", "z′", "H");
    }

    /** Each point as it is given, its image and H. */
    List<List<String>> rows() {
        var rows = new ArrayList<List<String>>();
        if (scene.isRefused()) return rows;
        int dimension = model.choice().dimension();
        double[] given = model.choice().wire().numbers();
        TransformTopic.Output output =
                Chains.images(dimension, scene.applied(model.step(), false), given);
        for (int i = 0; i < given.length / dimension; i++) {
            var row = new ArrayList<String>();
            row.add(String.valueOf(i + 1));
            for (int j = 0; j < dimension; j++) row.add(number(given[i * dimension + j]));
            double[] image =
                    Arrays.copyOfRange(
                            output.images().coordinates(), i * dimension, (i + 1) * dimension);
            double largest = Arrays.stream(image).map(Math::abs).max().orElse(0);
            for (double each : image) row.add(coordinate(each, largest));
            row.add(number(output.h()[i]));
            rows.add(row);
        }
        return rows;
    }

    private String coordinate(double value, double largest) {
        return Double.isFinite(value) ? Shown.coordinate(value, largest, 2, locale) : "—";
    }

    private String number(double value) {
        return Double.isFinite(value) ? Shown.number(value, 2, locale) : "—";
    }
}
