package rasterlab.app.coordinates.figure;

import java.awt.BorderLayout;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.language.Texts;

/** The picture of one plane, y upwards, in which points can be dragged. */
public abstract class PlaneStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private final transient ChoiceModel<?> model;
    private final PlaneView view;

    /**
     * @param texts the lab's, in which "stage" names the picture
     * @param onFailure told what painting threw, on any thread
     */
    protected PlaneStage(ChoiceModel<?> model, Texts texts, Consumer<Throwable> onFailure) {
        this(model, texts, () -> {}, onFailure);
    }

    /**
     * @param source what the scenes come from: waited for before the picture is
     */
    protected PlaneStage(
            ChoiceModel<?> model, Texts texts, Settling source, Consumer<Throwable> onFailure) {
        super(new BorderLayout());
        this.model = model;
        setOpaque(false);
        view =
                new PlaneView(
                        PlaneAxes.GEOMETRY,
                        Texts.of("canvas", texts.language()),
                        texts.text("stage"),
                        new Edits(),
                        source,
                        onFailure);
        add(view);
    }

    public final PlaneView shown() {
        return view;
    }

    /** A point is dragged to a place of the plane. */
    protected abstract void move(String point, double x, double y);

    /**
     * The picture is turned by dots of the screen.
     *
     * @return whether it can be turned
     */
    protected boolean turn(int viewRight, int viewDown) {
        return false;
    }

    /** Gives the keyboard to the picture's point. */
    public final void focusPoint() {
        view.focusPoint();
    }

    /** Ends the thread that paints. */
    @Override
    public final void close() {
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
            PlaneStage.this.move(point, x, y);
        }

        @Override
        public boolean turn(int viewRight, int viewDown) {
            return PlaneStage.this.turn(viewRight, viewDown);
        }
    }
}
