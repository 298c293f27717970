package rasterlab.app.visibility;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.language.Texts;
import rasterlab.app.visibility.scene.LookChoice;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.visibility.ClipPlane;

/** The controls of everything in a {@link LookChoice}. */
final class LookControls {
    /** The first entry of a list: as the scene has it, or none. */
    private static final String SCENE = "scene";

    private static final String ONE_EYE = "one";
    private static final double FARTHEST = 3;
    private static final double NEAREST = 0;
    private static final double WIDEST_EYES = 0.15;
    private static final int NOTCHES = 60;

    private final VisibilityLabModel model;
    private final Texts texts;
    private final Inspector column;
    private final NameChooser texture;
    private final NameChooser wrap;
    private final NameChooser environment;
    private final NameChooser hidden;
    private final NumberSlider crease;
    private final NameChooser cull;
    private final NameChooser sides;
    private final Map<LightTerm, JCheckBox> terms = new EnumMap<>(LightTerm.class);
    private final NumberSlider cue;
    private final NumberSlider near;
    private final NumberSlider far;
    private final JCheckBox planes;
    private final NameChooser stereo;
    private final NumberSlider eyes;

    LookControls(VisibilityLabModel model, Texts texts, Inspector column) {
        this.model = model;
        this.texts = texts;
        this.column = column;
        texture = names("texture", TextureMode.names(), this::texture);
        wrap = names("wrap", withScene(Wrap.values()), this::wrap);
        environment = names("environment", withScene(Mode.values()), this::environment);
        hidden =
                names(
                        "hidden",
                        HiddenLines.names(),
                        name -> look -> look.withHidden(HiddenLines.named(name)));
        crease = slider("crease", 0, 90, 45, LookChoice::withCrease);
        cull = names("cull", Cull.names(), name -> look -> look.withCull(Cull.named(name)));
        sides = names("sides", codes(Sides.values()), this::sides);
        column.row("terms", terms());
        cue = slider("cue", 0, 1, 20, LookChoice::withCue);
        near = slider("near", NEAREST, 2, NOTCHES, LookChoice::withNear);
        far = slider("far", 0.1, FARTHEST, NOTCHES, LookControls::withFar);
        planes = planes();
        stereo = names("stereo", withOneEye(), this::stereo);
        eyes = slider("eyes", 0.005, WIDEST_EYES, NOTCHES, LookChoice::withEyes);
    }

    private static List<String> withOneEye() {
        return Stream.concat(Stream.of(ONE_EYE), Stereo.StereoMode.names().stream()).toList();
    }

    private static List<String> withScene(Enum<?>... constants) {
        return Stream.concat(Stream.of(SCENE), codes(constants).stream()).toList();
    }

    private static List<String> codes(Enum<?>... constants) {
        return Arrays.stream(constants).map(LookControls::code).toList();
    }

    private static String code(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static <E extends Enum<E>> Optional<E> constant(E[] constants, String name) {
        return Arrays.stream(constants).filter(each -> code(each).equals(name)).findFirst();
    }

    private UnaryOperator<LookChoice> texture(String name) {
        return look -> look.withTexture(TextureMode.named(name));
    }

    private UnaryOperator<LookChoice> wrap(String name) {
        return look -> look.withWrap(constant(Wrap.values(), name));
    }

    private UnaryOperator<LookChoice> environment(String name) {
        return look -> look.withEnvironment(constant(Mode.values(), name));
    }

    private UnaryOperator<LookChoice> sides(String name) {
        return look -> look.withSides(constant(Sides.values(), name).orElse(Sides.SCENE));
    }

    private UnaryOperator<LookChoice> stereo(String name) {
        return look -> look.withStereo(constant(Stereo.StereoMode.values(), name));
    }

    /** The slider's end stands for no far plane. */
    private static LookChoice withFar(LookChoice look, double share) {
        return look.withFar(share >= FARTHEST ? Double.POSITIVE_INFINITY : share);
    }

    private void choose(UnaryOperator<LookChoice> change) {
        model.choose(choice -> choice.with(change.apply(choice.look())));
    }

    private NameChooser names(
            String key, List<String> names, Function<String, UnaryOperator<LookChoice>> change) {
        var chooser =
                new NameChooser(
                        key,
                        names,
                        name -> texts.textOr(key + "." + name, name),
                        name -> choose(change.apply(name)));
        column.row(key, chooser);
        return chooser;
    }

    private interface Setting {
        LookChoice of(LookChoice look, double number);
    }

    private NumberSlider slider(
            String key, double least, double most, int notches, Setting setting) {
        var slider =
                new NumberSlider(
                        key,
                        texts.text(key + ".hint"),
                        least,
                        most,
                        false,
                        notches,
                        number -> choose(look -> setting.of(look, number)));
        column.row(key, slider);
        return slider;
    }

    /** Planes come with a scene file; without the check mark they are gone until that is undone. */
    private JCheckBox planes() {
        var box = new JCheckBox();
        box.setName("clip-planes");
        box.addActionListener(e -> choose(look -> look.withClipPlanes(List.of())));
        column.row("clip-planes", box);
        return box;
    }

    private void refreshPlanes(List<ClipPlane> cutting) {
        column.showRow(planes, !cutting.isEmpty());
        planes.setSelected(true);
        planes.setText(texts.text("clip-planes.count", cutting.size()));
        planes.setToolTipText(
                texts.text("clip-planes.hint")
                        + cutting.stream()
                                .map(LookControls::written)
                                .collect(Collectors.joining("; ", " ", "")));
    }

    private static String written(ClipPlane p) {
        return "(%s, %s, %s, %s)".formatted(p.a(), p.b(), p.c(), p.d());
    }

    private JPanel terms() {
        var boxes = new JPanel(new FlowRows(4));
        FlowRows.keepWrapped(boxes);
        for (LightTerm term : LightTerm.values()) {
            var box = new JCheckBox(texts.text("term." + term.code()));
            box.setName("term." + term.code());
            box.addActionListener(e -> choose(look -> switched(look, term, box.isSelected())));
            terms.put(term, box);
            boxes.add(box);
        }
        return boxes;
    }

    /** The last term stays: without any there is nothing to see. */
    private static LookChoice switched(LookChoice look, LightTerm term, boolean on) {
        var seen = EnumSet.copyOf(look.terms());
        if (on) seen.add(term);
        else seen.remove(term);
        return seen.isEmpty() ? look : look.withTerms(seen);
    }

    /** Shows the model's present state. */
    void refresh() {
        VisibilityChoice choice = model.state().choice();
        LookChoice look = choice.look();
        refreshTexture(choice);
        boolean wires = choice.shading().equals("wire");
        column.showRow(hidden, wires);
        column.showRow(crease, wires);
        hidden.show(look.hidden().code());
        crease.show(look.crease(), number(look.crease(), 0) + "°");
        cull.show(look.cull().code());
        sides.show(code(look.sides()));
        terms.forEach((term, box) -> box.setSelected(look.terms().contains(term)));
        cue.show(look.cue(), look.cue() == 0 ? texts.text("off") : number(look.cue(), 2));
        near.show(
                look.near(), look.near() == 0 ? texts.text("off") : number(look.near(), 2) + " ρ");
        boolean endless = look.far() == Double.POSITIVE_INFINITY;
        far.show(
                Math.min(FARTHEST, look.far()),
                endless ? texts.text("off") : number(look.far(), 2) + " ρ");
        refreshPlanes(look.clipPlanes());
        boolean central = choice.projection().equals("perspective");
        stereo.setEnabled(central);
        stereo.show(look.stereo().map(Stereo.StereoMode::code).orElse(ONE_EYE));
        column.showRow(eyes, central && look.stereo().isPresent());
        eyes.show(look.eyes(), number(look.eyes(), 3) + " ρ");
    }

    private void refreshTexture(VisibilityChoice choice) {
        boolean textured = choice.shown().textured();
        boolean looked = textured && choice.look().texture() != TextureMode.NONE;
        column.showRow(texture, textured);
        column.showRow(wrap, looked);
        column.showRow(environment, looked);
        texture.show(choice.look().texture().code());
        wrap.show(choice.look().change().wrap().map(LookControls::code).orElse(SCENE));
        environment.show(
                choice.look().change().environment().map(LookControls::code).orElse(SCENE));
    }

    private String number(double value, int decimals) {
        return Shown.number(value, decimals, texts.locale());
    }
}
