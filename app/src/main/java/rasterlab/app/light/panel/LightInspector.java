package rasterlab.app.light.panel;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.LightLabState;
import rasterlab.app.light.LightOfFaces;
import rasterlab.app.light.LightOfPoints;
import rasterlab.app.light.LitBody;
import rasterlab.app.light.LitPlans;
import rasterlab.app.light.MaterialChoice;
import rasterlab.app.light.TopicBodies;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.least.LeastRows;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Substance;
import rasterlab.engine.scene.obj.UpAxis;

/** The lighting lab's controls and the formula with live numbers. */
final class LightInspector {
    private static final int NOTCHES = 100;

    /** Stands for the lab's own shadings. */
    private static final String LAB = "lab";

    private final LightLabModel model;
    private final Texts texts;
    private final LightMethods methods;
    private final Inspector column;
    private final ModeRow mode;
    private final NameChooser body;
    private final NameChooser up;
    private final NumberSlider detail;
    private final NameChooser normals;
    private final NameChooser shaded;
    private final JCheckBox arrows;
    private final JCheckBox mach;
    private LeastRows least;
    private NameChooser substance;
    private final List<Setting> settings = new ArrayList<>();
    private final Map<LightTerm, JCheckBox> terms = new EnumMap<>(LightTerm.class);
    private NameChooser reflection;
    private JCheckBox localViewer;
    private JCheckBox twoSided;
    private NumberSlider ambient;
    private LampControls lamps;
    private final FormulaView formula = new FormulaView("formula");
    private JLabel place;
    private AboutText about;

    private record Setting(ToDoubleFunction<MaterialChoice> value, NumberSlider slider) {}

    private interface Change {
        MaterialChoice of(MaterialChoice material, double number);
    }

    LightInspector(LightLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        methods = new LightMethods(texts);
        column = new Inspector(texts);
        mode = new ModeRow(model, texts, column);
        body = bodies();
        up = names("up", UpAxis.names(), name -> model.stand(UpAxis.named(name)));
        detail =
                new NumberSlider(
                        "detail",
                        texts.text("detail.hint"),
                        LitBody.COARSEST,
                        LitBody.FINEST,
                        true,
                        40,
                        this::chooseDetail);
        column.row("detail", detail);
        normals =
                names(
                        "normals",
                        withMine(LitBody.NORMALS),
                        name -> model.choose(c -> c.with(c.body().withNormals(name))));
        shaded =
                names(
                        "shaded",
                        List.of(LAB, LightOfPoints.TOPIC, LightOfFaces.TOPIC),
                        name ->
                                model.choose(
                                        choice ->
                                                name.equals(LAB)
                                                        ? choice.withShaded("")
                                                        : choice.byOwn(name)));
        arrows = box("arrows", on -> model.choose(choice -> choice.withArrows(on)));
        mach = box("mach", on -> model.choose(choice -> choice.withMach(on)));
    }

    /**
     * The sections that the constructor leaves out, in the column's order, as {@link
     * LabPanel#parts}.
     */
    List<Runnable> sections() {
        return List.of(
                this::addLeast,
                this::addFormula,
                this::addLamps,
                this::addMaterial,
                this::addTerms,
                this::addAbout);
    }

    private void addLeast() {
        least =
                new LeastRows(
                        column,
                        texts.language(),
                        wish -> model.choose(choice -> choice.with(wish)));
    }

    private void addFormula() {
        column.heading("heading.formula");
        place = column.value("place");
        column.wide(formula);
    }

    private void addLamps() {
        column.heading("heading.lamps");
        lamps = new LampControls(model, texts, column);
    }

    private void addMaterial() {
        column.heading("heading.material");
        substance =
                names(
                        "substance",
                        Substance.names(),
                        name ->
                                model.choose(
                                        choice ->
                                                choice.with(
                                                        MaterialChoice.of(Substance.named(name)))));
        material("ka", MaterialChoice.MOST, MaterialChoice::ambient, MaterialChoice::withAmbient);
        material("kd", MaterialChoice.MOST, MaterialChoice::diffuse, MaterialChoice::withDiffuse);
        material("ks", MaterialChoice.MOST, MaterialChoice::specular, MaterialChoice::withSpecular);
        material("ke", 1, MaterialChoice::emission, MaterialChoice::withEmission);
        material(
                "shininess",
                MaterialChoice.SHINIEST,
                MaterialChoice::shininess,
                MaterialChoice::withShininess);
    }

    private void addTerms() {
        column.heading("heading.terms");
        column.row("terms", termBoxes());
        reflection =
                names(
                        "reflection",
                        Stream.of(Reflection.values()).map(LightInspector::code).toList(),
                        name -> model.choose(choice -> choice.with(reflection(name))));
        ambient =
                new NumberSlider(
                        "ambient",
                        texts.text("ambient.hint"),
                        0,
                        1,
                        false,
                        NOTCHES,
                        share -> model.choose(choice -> choice.withAmbient(share)));
        column.row("ambient", ambient);
        localViewer = box("localViewer", on -> model.choose(c -> c.withLocalViewer(on)));
        twoSided = box("twoSided", on -> model.choose(c -> c.withTwoSides(on)));
    }

    private void addAbout() {
        column.heading("heading.methods");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private static String code(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static Reflection reflection(String code) {
        return Reflection.valueOf(code.toUpperCase(Locale.ROOT).replace('-', '_'));
    }

    /** A body is seen first with the detail and normals that were chosen last. */
    private void chooseBody(String name) {
        model.choose(
                choice ->
                        name.equals(choice.body().name())
                                ? choice
                                : choice.with(
                                        new LitBody(
                                                name,
                                                choice.body().detail(),
                                                choice.body().normals())));
    }

    private void chooseDetail(double faces) {
        model.choose(
                choice ->
                        choice.with(
                                new LitBody(
                                        choice.body().name(),
                                        (int) Math.round(faces),
                                        choice.body().normals())));
    }

    private static List<String> withMine(List<String> names) {
        var all = new ArrayList<>(names);
        all.add(OwnMethods.NAME);
        return all;
    }

    private NameChooser bodies() {
        var bodies =
                new NameChooser(
                        "body",
                        LitBody.NAMES,
                        name -> texts.textOr("body." + name, shown(name)),
                        this::chooseBody);
        column.row("body", bodies);
        return bodies;
    }

    /** Names a hazard's body by what tells it from the topic's others: the list is narrow. */
    private static String shown(String body) {
        if (GivenInput.is(body.substring(body.indexOf('/') + 1))) return "{…}";
        return TopicBodies.has(body)
                ? body.substring(body.indexOf('/') + 1).replace("/", ", ")
                : body;
    }

    private NameChooser names(String key, List<String> names, Consumer<String> chosen) {
        var chooser =
                new NameChooser(key, names, name -> texts.textOr(key + "." + name, name), chosen);
        column.row(key, chooser);
        return chooser;
    }

    private JCheckBox box(String key, Consumer<Boolean> chosen) {
        JCheckBox box = KeyedControls.box(key, texts, chosen);
        column.wide(box);
        return box;
    }

    private void material(
            String key, double most, ToDoubleFunction<MaterialChoice> value, Change change) {
        var slider =
                new NumberSlider(
                        key,
                        texts.text(key + ".hint"),
                        0,
                        most,
                        false,
                        NOTCHES,
                        number ->
                                model.choose(
                                        choice ->
                                                choice.with(change.of(choice.material(), number))));
        column.row(key, slider);
        settings.add(new Setting(value, slider));
    }

    private JPanel termBoxes() {
        var boxes = new JPanel(new FlowRows(4));
        FlowRows.keepWrapped(boxes);
        for (LightTerm term : LightTerm.values()) {
            var box = new JCheckBox(texts.text("term." + term.code()));
            box.setName("term." + term.code());
            box.addActionListener(
                    e -> model.choose(choice -> switched(choice, term, box.isSelected())));
            terms.put(term, box);
            boxes.add(box);
        }
        return boxes;
    }

    private static LightChoice switched(LightChoice choice, LightTerm term, boolean on) {
        var seen = EnumSet.noneOf(LightTerm.class);
        seen.addAll(choice.terms());
        if (on) seen.add(term);
        else seen.remove(term);
        return choice.withTerms(seen);
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        LightLabState state = model.state();
        LightChoice choice = state.choice();
        mode.refresh();
        body.showListed(choice.body().name(), LitBody.NAMES);
        up.show(choice.body().up().orElse(UpAxis.Y).code());
        column.showRow(up, choice.body().up().isPresent());
        column.showRow(detail, choice.body().hasDetail());
        detail.show(choice.body().detail(), Integer.toString(choice.body().detail()));
        normals.show(choice.body().normals());
        shaded.show(choice.shaded().isEmpty() ? LAB : choice.shaded());
        column.showRow(shaded, !choice.shaded().isEmpty() || model.hasOwnLight());
        arrows.setSelected(choice.arrows());
        mach.setSelected(choice.mach());
        least.show(
                choice.least(),
                true,
                state.drawn()
                        .flatMap(LightFrame.DrawnFrame::least)
                        .map(LitPlans.ComparedPictures::picture),
                model.plans.bills());
        substance.show(choice.material().substance().code());
        for (Setting each : settings) {
            double value = each.value().applyAsDouble(choice.material());
            each.slider().show(value, Shown.number(value, 2, texts.locale()));
        }
        terms.forEach((term, box) -> box.setSelected(choice.terms().contains(term)));
        reflection.show(code(choice.reflection()));
        ambient.show(choice.ambient(), Shown.number(choice.ambient(), 2, texts.locale()));
        localViewer.setSelected(choice.localViewer());
        twoSided.setSelected(choice.twoSided());
        lamps.refresh();
        var readings = new LightReadings(state, texts);
        place.setText(readings.place());
        formula.show(readings.formula());
        about.show(methods.of(choice));
    }
}
