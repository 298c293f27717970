package rasterlab.app.coordinates.view;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import rasterlab.app.canvas.AboutText;
import rasterlab.app.canvas.FormulaView;
import rasterlab.app.canvas.Inspector;
import rasterlab.app.canvas.MethodChooser;
import rasterlab.app.canvas.NameChooser;
import rasterlab.app.coordinates.figure.NumberTable;
import rasterlab.app.coordinates.figure.Parts;
import rasterlab.app.coordinates.figure.SliderField;
import rasterlab.app.language.Texts;

/** The lab's choosers, its live numbers, matrices and coordinate table. */
final class ViewInspector {
    private final ViewLabModel model;
    private final Texts texts;
    private final Texts translations;
    private final Inspector column;
    private final NameChooser kind;
    private final Map<ViewNumber, SliderField> numbers = new EnumMap<>(ViewNumber.class);
    private final JCheckBox stable;
    private final NameChooser stereo;
    private final MethodChooser method;
    private final JCheckBox vanishing;
    private final NameChooser vertex;
    private final JLabel family;
    private final JLabel stage;
    private final JLabel frame;
    private final JLabel gamma;
    private final JLabel operations;
    private final JLabel fit;
    private final JLabel error;
    private final FormulaView formulas = new FormulaView("formulas");
    private final NumberTable table;
    private final AboutText about;

    /**
     * @param mode adds the row that leads to the other labs
     */
    ViewInspector(ViewLabModel model, Texts texts, Consumer<Inspector> mode) {
        this.model = model;
        this.texts = texts;
        translations = Texts.of("coordinates.view", "topic", texts.language());
        column = new Inspector(texts);
        var parts = new Parts(column, texts);
        mode.accept(column);
        kind =
                parts.names(
                        "kind",
                        Stream.of(ViewKind.values()).map(ViewKind::code).toList(),
                        code -> model.choose(ViewKind.named(code)));
        for (ViewNumber each : ViewNumber.values())
            numbers.put(
                    each, parts.number(each.code(), each.range(), value -> model.set(each, value)));
        stable = parts.box("stable", kept -> model.change(model.choice().withStable(kept)));
        stereo =
                parts.names(
                        "stereo",
                        Stream.of(Stereoscopy.values()).map(Stereoscopy::code).toList(),
                        code -> model.rearrange(model.choice().with(Stereoscopy.named(code))));
        vanishing =
                parts.box(
                        "vanishing", shown -> model.rearrange(model.choice().withVanishing(shown)));
        method = parts.method(model.methods(), model::chooseMethod);

        column.heading("heading.stage");
        stage = column.value("stage.name");
        family = column.value("family");
        frame = column.value("frame");
        gamma = column.value("gamma");
        operations = column.value("operations");
        fit = column.value("fit");
        error = column.value("error");

        column.heading("heading.matrix");
        column.wide(formulas);

        column.heading("heading.table");
        vertex = vertexChooser();
        column.row("vertex", vertex);
        table = parts.table("heading.table");

        about = parts.about();
    }

    private NameChooser vertexChooser() {
        return new NameChooser(
                "vertex",
                IntStream.rangeClosed(1, ViewScene.HOUSE.size()).mapToObj(String::valueOf).toList(),
                name -> name,
                name -> model.change(model.choice().withVertex(Integer.parseInt(name))));
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        ViewChoice choice = model.choice();
        kind.show(choice.kind().code());
        numbers.forEach(
                (each, field) -> {
                    column.showRow(field, shown(each, choice));
                    field.show(choice.number(each));
                    field.setEnabled(each != ViewNumber.D || !choice.stable());
                });
        stable.setVisible(choice.kind().spherical());
        stable.setSelected(choice.stable());
        column.showRow(stereo, choice.kind() == ViewKind.SPHERICAL_LEFT);
        stereo.show(choice.stereo().code());
        stereo.setEnabled(choice.stable());
        vanishing.setVisible(choice.kind().central());
        vanishing.setSelected(choice.vanishing());
        method.show(choice.method());
        vertex.show(String.valueOf(choice.vertex()));
        showNumbers();
    }

    /** The window's size where it matters, and the eyes' distance where there are two. */
    private boolean shown(ViewNumber number, ViewChoice choice) {
        return switch (number) {
            case WIDTH, HEIGHT ->
                    model.stage().space() == ViewStage.Space.SCREEN
                            || choice.kind() == ViewKind.LOOK_AT;
            case SEPARATION -> choice.twoEyes();
            default -> choice.kind().numbers().contains(number);
        };
    }

    private void showNumbers() {
        var readings = new ViewReadings(model, texts);
        stage.setText(readings.stage());
        family.setText(readings.family());
        column.showRow(frame, model.stage().space().deep());
        frame.setText(readings.frame());
        column.showRow(gamma, model.choice().kind().spherical());
        gamma.setText(readings.gamma());
        column.showRow(operations, model.choice().kind().spherical());
        operations.setText(readings.operations());
        boolean screen = model.stage().space() == ViewStage.Space.SCREEN;
        column.showRow(fit, screen && model.choice().kind() != ViewKind.LOOK_AT);
        fit.setText(readings.fit());
        error.setText(readings.error());
        formulas.show(readings.formulas());
        table.show(readings.headings(), readings.rows(), model.choice().vertex() - 1);
        about.show(
                translations,
                model.method(),
                "",
                model.scene().refusal().isEmpty() ? "" : texts.text("note.refused"));
    }
}
