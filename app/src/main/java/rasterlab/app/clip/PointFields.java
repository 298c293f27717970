package rasterlab.app.clip;

import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberField;
import rasterlab.app.clip.scene.ClipGrip;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.language.Texts;

/** The selected point's coordinates as number fields: x and y, and z in space. */
final class PointFields extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final double STEP = 0.25;
    private static final double STEP_IN_SPACE = 0.0625;

    private final transient ClipLabModel model;
    private final NumberField x;
    private final NumberField y;
    private final NumberField z;

    /**
     * @param space whether there is a z
     */
    PointFields(ClipLabModel model, Texts texts, boolean space) {
        super(
                new MigLayout(
                        "insets 0, gap 6",
                        "[grow,fill,0::][grow,fill,0::]" + (space ? "[grow,fill,0::]" : "")));
        this.model = model;
        x = field("x", texts, space);
        y = field("y", texts, space);
        z = field("z", texts, space);
        add(x, "wmin 0");
        add(y, "wmin 0");
        if (space) add(z, "wmin 0");
    }

    private NumberField field(String axis, Texts texts, boolean space) {
        return new NumberField(
                (space ? "space." : "plane.") + axis,
                texts.text("point.coordinate", axis),
                -Double.MAX_VALUE,
                Double.MAX_VALUE,
                space ? STEP_IN_SPACE : STEP,
                texts.locale(),
                value -> entered(axis, value));
    }

    private void entered(String axis, double value) {
        ClipGrip grip = model.state().selected();
        ClipScene scene = model.state().choice().scene();
        if (scene instanceof VolumeScene volume) {
            model.volume(old -> old.withEnd(grip, changed(volume.end(grip), axis, value)));
            return;
        }
        ClipPoint at = scene.grips().get(grip);
        model.move(grip, axis.equals("x") ? value : at.x(), axis.equals("y") ? value : at.y());
    }

    private static SpacePoint changed(SpacePoint p, String axis, double value) {
        return switch (axis) {
            case "x" -> new SpacePoint(value, p.y(), p.z());
            case "y" -> new SpacePoint(p.x(), value, p.z());
            default -> new SpacePoint(p.x(), p.y(), value);
        };
    }

    /** Shows the selected point's present place. */
    void refresh() {
        ClipGrip grip = model.state().selected();
        ClipScene scene = model.state().choice().scene();
        if (scene instanceof VolumeScene volume) {
            SpacePoint at = volume.end(grip);
            x.show(at.x());
            y.show(at.y());
            z.show(at.z());
        } else if (scene.grips().containsKey(grip)) {
            ClipPoint at = scene.grips().get(grip);
            x.show(at.x());
            y.show(at.y());
        }
    }
}
