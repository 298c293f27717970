package rasterlab.app.coordinates.view;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.coordinates.figure.NamedControls;
import rasterlab.app.coordinates.figure.NumberTable;
import rasterlab.app.coordinates.figure.SliderField;
import rasterlab.app.language.Texts;

/** The lab's choosers, its live numbers, matrices and coordinate table. */
final class ViewInspector {
    private final ViewLabModel model;
    private final Texts texts;
    private final Texts explanations;
    private final Inspector column;
    private final NamedControls parts;
    private final Consumer<Inspector> mode;
    private NameChooser kind;
    private final Map<ViewNumber, SliderField> numbers = new EnumMap<>(ViewNumber.class);
    private JCheckBox stable;
    private NameChooser stereo;
    private MethodChooser method;
    private JCheckBox vanishing;
    private NameChooser vertex;
    private JLabel family;
    private JLabel stage;
    private JLabel frame;
    private JLabel gamma;
    private JLabel operations;
    private JLabel fit;
    private JLabel error;
    private final FormulaView formulas = new FormulaView("formulas");
    private NumberTable table;
    private AboutText about;

    /**
     * @param mode adds the row that leads to the other labs
     */
    ViewInspector(ViewLabModel model, Texts texts, Consumer<Inspector> mode) {
        this.model = model;
        this.texts = texts;
        explanations = TopicTexts.of("transform", texts.language()).texts();
        column = new Inspector(texts);
        parts = new NamedControls(column, texts);
        this.mode = mode;
    }

    /** All controls, in the column's order, as {@link LabPanel#parts}. */
    List<Runnable> sections() {
        var sections = new ArrayList<Runnable>();
        sections.add(() -> mode.accept(column));
        sections.add(this::addKind);
        for (ViewNumber each : ViewNumber.values()) sections.add(() -> addNumber(each));
        sections.addAll(
                List.of(this::addChoices, this::addReadings, this::addTable, this::addAbout));
        return sections;
    }

    private void addKind() {
        kind =
                parts.names(
                        "kind",
                        Stream.of(ViewKind.values()).map(ViewKind::code).toList(),
                        code -> model.choose(ViewKind.named(code)));
    }

    private void addNumber(ViewNumber number) {
        numbers.put(
                number,
                parts.number(number.code(), number.range(), value -> model.set(number, value)));
    }

    private void addChoices() {
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
    }

    private void addReadings() {
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
    }

    private void addTable() {
        column.heading("heading.table");
        vertex = vertexChooser();
        column.row("vertex", vertex);
        table = parts.table("heading.table");
    }

    private void addAbout() {
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
        showChoice();
        showNumbers();
    }

    void showChoice() {
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
    }

    /** The window's size where it matters, and the eyes' distance where there are two. */
    private boolean shown(ViewNumber number, ViewChoice choice) {
        return switch (number) {
            case WIDTH, HEIGHT ->
                    model.stage().space() == ViewStage.CoordinateSpace.SCREEN
                            || choice.kind() == ViewKind.LOOK_AT;
            case SEPARATION -> choice.twoEyes();
            default -> choice.kind().numbers().contains(number);
        };
    }

    void showNumbers() {
        var readings = new ViewReadings(model, texts);
        stage.setText(readings.stage());
        family.setText(readings.family());
        column.showRow(frame, model.stage().space().deep());
        frame.setText(readings.frame());
        column.showRow(gamma, model.choice().kind().spherical());
        gamma.setText(readings.gamma());
        column.showRow(operations, model.choice().kind().spherical());
        operations.setText(readings.operations());
        boolean screen = model.stage().space() == ViewStage.CoordinateSpace.SCREEN;
        column.showRow(fit, screen && model.choice().kind() != ViewKind.LOOK_AT);
        fit.setText(readings.fit());
        error.setText(readings.error());
        formulas.show(readings.formulas());
        table.show(readings.headings(), readings.rows(), model.choice().vertex() - 1);
        about.show(
                explanations,
                model.method().name(),
                "",
                model.scene().refusal().isEmpty() ? "" : texts.text("note.refused"));
    }
}
