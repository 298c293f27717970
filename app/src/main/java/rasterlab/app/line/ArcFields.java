package rasterlab.app.line;

import java.util.function.IntConsumer;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberField;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.ArcFigure;
import rasterlab.app.line.figure.FigureLabModel;

/** Centre and half-axes as number fields. */
final class ArcFields {
    private final NumberField x;
    private final NumberField y;
    private final NumberField radiusX;
    private final NumberField radiusY;
    private final JPanel center = row();
    private final JPanel radii = row();

    ArcFields(FigureLabModel model, Texts texts) {
        x =
                field(
                        "centre.x",
                        texts,
                        value -> model.arc(old -> old.withCenter(value, old.centerY())));
        y =
                field(
                        "centre.y",
                        texts,
                        value -> model.arc(old -> old.withCenter(old.centerX(), value)));
        radiusX = field("radius.x", texts, value -> model.arc(old -> old.withRadiusX(value)));
        radiusY = field("radius.y", texts, value -> model.arc(old -> old.withRadiusY(value)));
        center.add(x, "wmin 0");
        center.add(y, "wmin 0");
        radii.add(radiusX, "wmin 0");
        radii.add(radiusY, "wmin 0");
    }

    private static JPanel row() {
        return new JPanel(
                new MigLayout("insets 0, gap 6, hidemode 3", "[grow,fill,0::][grow,fill,0::]"));
    }

    private static NumberField field(String name, Texts texts, IntConsumer entered) {
        var field =
                new NumberField(
                        name,
                        texts.text(name + ".hint"),
                        Integer.MIN_VALUE,
                        Integer.MAX_VALUE,
                        1,
                        texts.locale(),
                        value -> entered.accept((int) Math.rint(value)));
        field.takeOnlyWhole();
        return field;
    }

    JPanel center() {
        return center;
    }

    JPanel radii() {
        return radii;
    }

    void show(ArcFigure arc) {
        x.show(arc.centerX());
        y.show(arc.centerY());
        radiusX.show(arc.radiusX());
        radiusY.show(arc.radiusY());
        radiusY.setVisible(!arc.round());
    }
}
