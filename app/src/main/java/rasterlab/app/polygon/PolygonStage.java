package rasterlab.app.polygon;

import java.awt.CardLayout;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.PicturePair;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.outcome.MethodOutcome;
import rasterlab.app.polygon.outcome.PolygonResults;

/** The picture of the chosen method, and beside it that of a second one. */
final class PolygonStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private static final String PLANE = "plane";
    private static final String PIXELS = "pixels";

    private final transient PolygonLabModel model;
    private final transient Texts texts;
    private final CardLayout cards = new CardLayout();
    private final PicturePair plane;
    private final PicturePair pixels;
    private final transient PolygonPictures pictures;

    /**
     * @param onFailure told what painting threw, on any thread
     */
    PolygonStage(PolygonLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        this.model = model;
        this.texts = texts;
        pictures = new PolygonPictures(model.topics(), texts);
        setLayout(cards);
        setOpaque(false);
        plane = pair(PlaneAxes.GEOMETRY, onFailure);
        pixels = pair(PlaneAxes.RASTER, onFailure);
        add(plane, PLANE);
        add(pixels, PIXELS);
        refresh();
    }

    private PicturePair pair(PlaneAxes axes, Consumer<Throwable> onFailure) {
        return new PicturePair(
                view("stage", axes, onFailure), view("stage.other", axes, onFailure));
    }

    private PlaneView view(String name, PlaneAxes axes, Consumer<Throwable> onFailure) {
        var view =
                new PlaneView(
                        axes,
                        Texts.of("canvas", texts.language()),
                        texts.text(name),
                        new Edits(),
                        model::settle,
                        onFailure);
        view.setName(name);
        return view;
    }

    /** Gives the keyboard to the point that had it last. */
    void focusPoint() {
        shown().chosen().focusPoint();
    }

    SvgDrawing svg() {
        return shown().svg();
    }

    private PicturePair shown() {
        return model.state().results().scene().mode().raster() ? pixels : plane;
    }

    /** Ends the threads that paint. */
    @Override
    public void close() {
        plane.close();
        pixels.close();
    }

    /** Shows the model's present state. */
    void refresh() {
        PolygonLabState state = model.state();
        PolygonResults results = state.results();
        // Another mode's figure is shown when its answer is there.
        if (results.scene().mode() != state.choice().mode()) return;
        PicturePair pair = shown();
        cards.show(this, pair == pixels ? PIXELS : PLANE);
        boolean together = state.choice().difference();
        Optional<MethodOutcome> second = together ? Optional.empty() : results.other();
        PolygonFigure chosen = state.choice().scene().figure();
        Rectangle2D all = PolygonFraming.of(chosen);
        pair.arrange(all, second.isPresent());
        pair.chosen().stepAtLeast(chosen.leastStep());
        PlanePicture first =
                together && results.other().isPresent()
                        ? pictures.difference(results, state.step())
                        : pictures.of(results.scene(), results.outcome(), state.step());
        pair.chosen()
                .show(
                        first,
                        points(state.choice().scene()),
                        note(results.outcome(), state.finished(), second.isPresent()),
                        all,
                        state.arrangement());
        second.ifPresent(outcome -> showOther(pair, outcome, all));
    }

    private void showOther(PicturePair pair, MethodOutcome outcome, Rectangle2D all) {
        PolygonLabState state = model.state();
        int step = state.finished() ? outcome.steps() + 1 : state.step();
        pair.other()
                .show(
                        pictures.of(state.results().scene(), outcome, step),
                        List.of(),
                        note(outcome, step > outcome.steps(), true),
                        all,
                        state.arrangement());
    }

    /** A note on what the picture alone would not tell; with two pictures also whose each is. */
    private String note(MethodOutcome outcome, boolean finished, boolean named) {
        PolygonFigure figure = model.state().results().scene().figure();
        String note = finished ? PolygonNotes.about(figure, outcome, texts) : "";
        return note.isEmpty() && named ? OwnWords.called(outcome.method(), texts.language()) : note;
    }

    /**
     * The points at the places that the user chose last, though the picture may not be there yet.
     */
    private List<PlanePoint> points(PolygonScene scene) {
        var points = new ArrayList<PlanePoint>();
        scene.figure()
                .grips()
                .forEach(
                        (grip, at) -> {
                            if (at.isFinite()) points.add(point(scene.mode(), grip, at));
                        });
        return points;
    }

    private PlanePoint point(PolygonMode mode, Grip grip, PolygonPoint at) {
        String said =
                PolygonReadings.named(mode, grip, texts)
                        + " "
                        + Shown.point(at.x(), at.y(), texts.locale());
        PlanePoint.HandleShape form =
                switch (grip.kind()) {
                    case CORNER -> PlanePoint.HandleShape.DIAMOND;
                    case POINT, SEED -> PlanePoint.HandleShape.CIRCLE;
                    case PEN -> PlanePoint.HandleShape.SQUARE;
                };
        return new PlanePoint(
                grip.componentName(),
                at.x(),
                at.y(),
                form,
                PolygonReadings.label(mode, grip),
                texts.text("grip.keys", said));
    }

    /** Passes what mouse and keyboard do on to the model. */
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
            grip(point).ifPresent(grip -> model.move(grip, x, y));
        }

        @Override
        public void add(double x, double y) {
            model.click(x, y);
        }

        @Override
        public void select(String point) {
            grip(point).ifPresent(model::select);
        }

        @Override
        public void remove(String point) {
            grip(point).ifPresent(model::select);
            model.shrink();
        }

        private Optional<Grip> grip(String name) {
            return model.state().choice().scene().figure().grips().keySet().stream()
                    .filter(each -> each.componentName().equals(name))
                    .findFirst();
        }
    }
}
