package rasterlab.app.polygon;

import java.util.function.DoubleConsumer;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberField;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.PolygonPoint;

/** The selected point's coordinates as number fields. */
final class PlaceFields extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final double STEP = 0.25;

    private final transient PolygonLabModel model;
    private final NumberField x;
    private final NumberField y;

    PlaceFields(PolygonLabModel model, Texts texts) {
        super(new MigLayout("insets 0, gap 6", "[grow,fill,0::][grow,fill,0::]"));
        this.model = model;
        x = field("x", texts, value -> move(value, place().y()));
        y = field("y", texts, value -> move(place().x(), value));
        add(x, "wmin 0");
        add(y, "wmin 0");
    }

    private static NumberField field(String axis, Texts texts, DoubleConsumer entered) {
        return new NumberField(
                "place." + axis,
                texts.text("point.coordinate", axis),
                -Double.MAX_VALUE,
                Double.MAX_VALUE,
                STEP,
                texts.locale(),
                entered);
    }

    private void move(double toX, double toY) {
        model.move(model.state().selected(), toX, toY);
        refresh();
    }

    private PolygonPoint place() {
        PolygonLabState state = model.state();
        return state.choice()
                .scene()
                .figure()
                .grips()
                .getOrDefault(state.selected(), new PolygonPoint(0, 0));
    }

    /** Shows the selected point's present place. */
    void refresh() {
        x.show(place().x());
        y.show(place().y());
    }
}
