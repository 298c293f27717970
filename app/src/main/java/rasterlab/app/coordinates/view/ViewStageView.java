package rasterlab.app.coordinates.view;

import java.awt.CardLayout;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.Shown;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.language.Texts;

/** The picture of the present stage: y upwards, or downwards where the stage's own y does so. */
final class ViewStageView extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private static final double DEGREES_PER_DOT = 0.5;

    /** The suffix of a component's name that a visible component has already. */
    private static final String NAME = "stage";

    private final transient ViewLabModel model;
    private final transient Texts texts;
    private final CardLayout cards = new CardLayout();
    private final PlaneView up;
    private final PlaneView down;
    private transient Rectangle2D everything = new Rectangle2D.Double(0, 0, 1, 1);
    private transient Optional<StagePoint> vertex = Optional.empty();

    ViewStageView(ViewLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        this.model = model;
        this.texts = texts;
        setLayout(cards);
        setOpaque(false);
        up = view(PlaneAxes.GEOMETRY, NAME, onFailure);
        down = view(PlaneAxes.RASTER, NAME + ".down", onFailure);
        refresh();
    }

    private PlaneView view(PlaneAxes axes, String name, Consumer<Throwable> onFailure) {
        var view =
                new PlaneView(
                        axes,
                        Texts.of("canvas", texts.language()),
                        texts.text("stage"),
                        new Edits(),
                        () -> {},
                        onFailure);
        view.setName(name);
        add(view, name);
        return view;
    }

    private boolean pointsDown() {
        ViewStage.CoordinateSpace space = model.stage().space();
        ViewKind kind = model.choice().kind();
        if (space == ViewStage.CoordinateSpace.SCREEN) return kind != ViewKind.LOOK_AT;
        return space == ViewStage.CoordinateSpace.PICTURE && kind.yDown();
    }

    PlaneView shown() {
        return pointsDown() ? down : up;
    }

    void refresh() {
        int stage = model.step();
        Figure figure = ViewFigure.of(model.scene(), stage);
        boolean plane = figure.ruled() && model.choice().vanishing();
        everything = plane ? ViewFigure.frame(figure.marks()) : MarkBounds.around(figure.marks());
        vertex = ViewFigure.vertex(model.scene(), stage);
        PlaneView shown = shown();
        shown.show(
                figure,
                vertex.map(this::point).stream().toList(),
                note(),
                everything,
                model.arrangement() * (model.last() + 1) + stage);
        cards.show(this, shown == up ? NAME : NAME + ".down");
    }

    private PlanePoint point(StagePoint at) {
        String said =
                texts.text(
                        "vertex.said",
                        model.choice().vertex(),
                        Shown.point(at.x(), at.y(), texts.locale()));
        return new PlanePoint(
                "handle.vertex", at.x(), at.y(), PlanePoint.HandleShape.CIRCLE, "", said);
    }

    private String note() {
        ViewScene scene = model.scene();
        if (!scene.refusal().isEmpty()) return texts.text("note.refused");
        long behind = scene.images().get(model.step()).behind();
        if (behind > 0) return texts.text("note.behind", behind);
        return "";
    }

    /** Gives the keyboard to the chosen vertex. */
    void focusPoint() {
        shown().focusPoint();
    }

    /** Ends the threads that paint. */
    @Override
    public void close() {
        up.close();
        down.close();
    }

    /** The chosen vertex is a handle by which everything is turned. */
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
            if (vertex.isEmpty()) return;
            double size = Math.max(everything.getWidth(), everything.getHeight());
            double upwards = pointsDown() ? -1 : 1;
            model.turn((x - vertex.get().x()) / size, upwards * (y - vertex.get().y()) / size);
        }

        @Override
        public boolean turn(int viewRight, int viewDown) {
            if (!model.stage().space().deep()) return false;
            model.turnBy(viewRight * DEGREES_PER_DOT, viewDown * DEGREES_PER_DOT);
            return true;
        }
    }
}
