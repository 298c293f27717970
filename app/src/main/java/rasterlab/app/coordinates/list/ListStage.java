package rasterlab.app.coordinates.list;

import java.awt.CardLayout;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.Shown;
import rasterlab.app.coordinates.figure.Box;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Spot;
import rasterlab.app.language.Texts;

/** The picture of a list; in the plane the subject's corners can be dragged. */
final class ListStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private static final double DEGREES_PER_DOT = 0.5;

    /** So many points of a subject are its corners. */
    private static final int CORNERS = 4;

    private final transient ListLabModel model;
    private final transient Texts texts;
    private final PlaneView view;
    private transient Rectangle2D everything = new Rectangle2D.Double(0, 0, 1, 1);
    private transient Spot turned = new Spot(0, 0);

    ListStage(ListLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(new CardLayout());
        this.model = model;
        this.texts = texts;
        setOpaque(false);
        view =
                new PlaneView(
                        PlaneAxes.GEOMETRY,
                        Texts.of("canvas", texts.language()),
                        texts.text("stage"),
                        new Edits(),
                        () -> {},
                        onFailure);
        add(view, "stage");
        refresh();
    }

    PlaneView shown() {
        return view;
    }

    void refresh() {
        Figure figure = ListFigure.of(model.scene(), model.step());
        everything = Box.around(ListFigure.of(model.scene(), model.last()).marks());
        everything.add(Box.around(figure.marks()));
        view.show(figure, points(), note(), everything, model.arrangement());
    }

    private String note() {
        ListScene scene = model.scene();
        if (scene.isRefused()) return ListReadings.refusal(scene, texts);
        return scene.wrong() ? texts.text("note.wrong") : "";
    }

    private List<PlanePoint> points() {
        return model.choice().dimension() == 2 ? corners() : List.of(grip());
    }

    private List<PlanePoint> corners() {
        var points = new ArrayList<PlanePoint>();
        List<Double> numbers = model.choice().points();
        for (int i = 0; i < Math.min(CORNERS, numbers.size() / 2); i++) {
            double x = numbers.get(2 * i);
            double y = numbers.get(2 * i + 1);
            String said = texts.text("corner.said", i + 1, Shown.point(x, y, texts.locale()));
            points.add(new PlanePoint("corner." + i, x, y, PlanePoint.Form.DIAMOND, "", said));
        }
        return points;
    }

    /** The origin, by which space is turned. */
    private PlanePoint grip() {
        turned = new Spot(0, 0);
        return new PlanePoint("turn", 0, 0, PlanePoint.Form.CIRCLE, "", texts.text("turn.said"));
    }

    void focusPoint() {
        view.focusPoint();
    }

    /** Ends the thread that paints. */
    @Override
    public void close() {
        view.close();
    }

    private final class Edits implements PlaneEdits {
        @Override
        public void beginDrag() {
            model.beginDrag();
        }

        @Override
        public void endDrag() {
            model.endDrag();
        }

        @Override
        public void move(String point, double x, double y) {
            if (point.startsWith("corner.")) {
                model.movePoint(Integer.parseInt(point.substring("corner.".length())), x, y);
                return;
            }
            double size = Math.max(everything.getWidth(), everything.getHeight());
            model.turn((x - turned.x()) / size, (y - turned.y()) / size);
        }

        @Override
        public boolean turn(int viewRight, int viewDown) {
            if (model.choice().dimension() == 2) return false;
            model.turnBy(viewRight * DEGREES_PER_DOT, viewDown * DEGREES_PER_DOT);
            return true;
        }
    }
}
