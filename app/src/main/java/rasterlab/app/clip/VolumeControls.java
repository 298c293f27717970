package rasterlab.app.clip;

import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSlider;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberField;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.Screen;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.clip.scene.VolumeSpace;
import rasterlab.app.clip.scene.VolumeViewpoint;
import rasterlab.app.language.Texts;

/**
 * The controls that only the view volume has: its space, its viewpoint, its nearest plane and its
 * screen.
 */
final class VolumeControls {
    private static final double LEAST = 1e-12;

    private final ClipLabModel model;
    private final Texts texts;
    private final NameChooser space;
    private final JSlider alpha;
    private final JSlider beta;
    private final NumberField zmin;
    private final NumberField distance;
    private final NumberField farthest;
    private final NumberField halfWidth;
    private final NumberField halfHeight;
    private final List<JComponent> rows;
    private boolean refreshing;

    VolumeControls(ClipLabModel model, Texts texts, Inspector column) {
        this.model = model;
        this.texts = texts;
        space =
                new NameChooser(
                        "space",
                        Stream.of(VolumeSpace.values()).map(VolumeSpace::code).toList(),
                        code -> texts.text("space." + code),
                        code -> model.volume(old -> old.withSpace(VolumeSpace.coded(code))));
        alpha = slider("alpha", 180);
        beta = slider("beta", 90);
        zmin = field("zmin", LEAST, Math.nextDown(1.0), 0.0625, value -> scene().withZmin(value));
        distance = field("screen.distance", value -> screen(value, 0));
        halfWidth = field("screen.width", value -> screen(value, 1));
        halfHeight = field("screen.height", value -> screen(value, 2));
        farthest = field("screen.farthest", value -> screen(value, 3));
        JPanel depth = pair(zmin, farthest);
        JPanel screen = pair(distance, halfWidth, halfHeight);
        JPanel angles = pair(alpha, beta);
        column.row("space", space);
        column.row("viewpoint", angles);
        column.row("depth", depth);
        column.row("screen", screen);
        rows = List.of(space, angles, depth, screen);
    }

    private VolumeScene scene() {
        return model.state().choice().volume();
    }

    private static JPanel pair(JComponent... controls) {
        var pair = new JPanel(new MigLayout("insets 0, gap 6", ""));
        for (JComponent control : controls) pair.add(control, "wmin 0, w 0, grow, push, sizegroup");
        return pair;
    }

    private JSlider slider(String key, int most) {
        var slider = new JSlider(-most, most);
        slider.setName(key);
        slider.setToolTipText(texts.text(key + ".hint"));
        slider.getAccessibleContext().setAccessibleName(texts.text(key + ".hint"));
        slider.addChangeListener(
                e -> {
                    if (!refreshing) turned();
                });
        return slider;
    }

    private void turned() {
        var view = new VolumeViewpoint(alpha.getValue(), beta.getValue());
        model.volume(old -> old.withView(view));
    }

    private NumberField field(
            String key, double low, double high, double step, DoubleFunction<VolumeScene> changed) {
        return new NumberField(
                key,
                texts.text(key + ".hint"),
                low,
                high,
                step,
                texts.locale(),
                value -> model.volume(old -> changed.apply(value)));
    }

    private NumberField field(String key, DoubleFunction<VolumeScene> changed) {
        return field(key, 0.01, 1000, 0.25, changed);
    }

    private VolumeScene screen(double value, int part) {
        Screen old = scene().screen();
        return scene().withScreen(
                        new Screen(
                                part == 0 ? value : old.distance(),
                                part == 1 ? value : old.halfWidth(),
                                part == 2 ? value : old.halfHeight(),
                                part == 3 ? value : old.farthest()));
    }

    /** Shows the model's present volume, or nothing in another mode. */
    void refresh(Inspector column) {
        boolean shown = model.state().choice().mode() == ClipMode.VOLUME;
        for (JComponent row : rows) column.showRow(row, shown);
        refreshing = true;
        VolumeScene scene = scene();
        space.show(scene.space().code());
        alpha.setValue((int) Math.round(scene.view().alphaDegrees()));
        beta.setValue((int) Math.round(scene.view().betaDegrees()));
        refreshing = false;
        zmin.show(scene.zmin());
        distance.show(scene.screen().distance());
        halfWidth.show(scene.screen().halfWidth());
        halfHeight.show(scene.screen().halfHeight());
        farthest.show(scene.screen().farthest());
    }
}
