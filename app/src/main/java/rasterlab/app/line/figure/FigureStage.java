package rasterlab.app.line.figure;

import java.awt.CardLayout;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
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
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelSet;

/** The figure by the chosen method, beside it by a second one; or the chart of brightness. */
public final class FigureStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private static final String PIXELS = "pixels";
    private static final String CHART = "chart";

    private final transient FigureLabModel model;
    private final transient Texts texts;
    private final CardLayout cards = new CardLayout();
    private final PicturePair pixels;
    private final PlaneView chart;
    private int sought;

    /**
     * @param onFailure told what painting threw, on any thread
     */
    public FigureStage(FigureLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        this.model = model;
        this.texts = texts;
        setLayout(cards);
        setOpaque(false);
        pixels =
                new PicturePair(
                        view("stage", PlaneAxes.RASTER, onFailure),
                        view("stage.other", PlaneAxes.RASTER, onFailure));
        chart = view("stage", PlaneAxes.GRAPH, onFailure);
        add(pixels, PIXELS);
        add(chart, CHART);
        refresh();
    }

    private PlaneView view(String name, PlaneAxes axes, Consumer<Throwable> onFailure) {
        var view =
                new PlaneView(
                        axes,
                        Texts.of("canvas", texts.language()),
                        texts.text("figure." + name),
                        new Edits(),
                        model::settle,
                        onFailure);
        view.setName(name);
        view.stepAtLeast(axes == PlaneAxes.GRAPH ? 1 : 0);
        return view;
    }

    private PlaneView shown() {
        return model.state().drawn().mode() == LineMode.BRIGHTNESS ? chart : pixels.chosen();
    }

    /** Gives the keyboard to the point that had it last. */
    public void focusPoint() {
        shown().focusPoint();
    }

    public SvgDrawing svg() {
        return shown() == chart ? chart.svg() : pixels.svg();
    }

    /** Ends the threads that paint. */
    @Override
    public void close() {
        pixels.close();
        chart.close();
    }

    /** Shows the model's present state. */
    public void refresh() {
        FigureState state = model.state();
        // Another mode's figure is shown when it is drawn.
        if (state.drawn().mode() != state.scene().mode()) return;
        Rectangle2D all = FigureFraming.of(state.scene().figure());
        cards.show(this, shown() == chart ? CHART : PIXELS);
        boolean arc = state.drawn().figure() instanceof ArcFigure;
        Optional<FigureDrawing> second = arc ? state.other() : Optional.empty();
        boolean opened = second.isPresent() && !pixels.other().isVisible();
        pixels.arrange(all, second.isPresent());
        pixels.chosen().stepAtLeast(arc ? 1 : 0);
        PixelSet onlyChosen = alone(PixelDifference::extra);
        shown().show(
                        picture(state.drawing(), state.step(), onlyChosen),
                        points(),
                        note(state.drawing(), second.isPresent()),
                        all,
                        state.arrangement());
        second.ifPresent(
                other -> {
                    int step = state.finished() ? other.steps() : state.step();
                    pixels.other()
                            .show(
                                    picture(
                                            other,
                                            Math.min(step, other.steps()),
                                            alone(PixelDifference::missing)),
                                    List.of(),
                                    note(other, true),
                                    all,
                                    state.arrangement());
                });
        // The figure may have left the second picture while that was not shown.
        if (opened || state.sought() != sought) follow(state.scene().figure());
        sought = state.sought();
    }

    private void follow(DrawnFigure figure) {
        for (PlaneView each : List.of(pixels.chosen(), pixels.other()))
            each.follow(sight -> FigureFraming.isSeen(figure, sight));
    }

    /** The pixels that only one of two methods lights; they are told when all are lit. */
    private PixelSet alone(Function<PixelDifference, PixelSet> side) {
        FigureState state = model.state();
        return state.drawings()
                .apart()
                .filter(apart -> state.finished())
                .map(side)
                .orElse(PixelSet.EMPTY);
    }

    /**
     * @param alone pixels that the other method does not light
     */
    private PlanePicture picture(FigureDrawing drawing, int step, PixelSet alone) {
        DrawnFigure figure = model.state().drawn().figure();
        if (figure instanceof ArcFigure arc) return new ArcPicture(arc, drawing, step, alone);
        if (figure instanceof PenFigure pen) return new PenPicture(pen);
        var methods = new ArrayList<String>();
        var light = new ArrayList<List<Double>>();
        methods.add(drawing.method());
        light.add(drawing.brightness());
        model.state()
                .other()
                .filter(other -> !other.method().equals(drawing.method()))
                .ifPresent(
                        other -> {
                            methods.add(other.method());
                            light.add(other.brightness());
                        });
        var words =
                new BrightnessPicture.BrightnessWords(
                        texts.text("figure.even"),
                        texts.text("chart.degrees"),
                        texts.text("figure.light"));
        return new BrightnessPicture((SlopeFigure) figure, methods, light, words);
    }

    /** A note on what the picture alone would not tell; with two pictures also whose each is. */
    private String note(FigureDrawing drawing, boolean named) {
        String method = OwnWords.called(drawing.method(), texts.language());
        return switch (drawing.ending()) {
            case ENDLESS -> texts.text("note.endless", method, drawing.steps());
            case REFUSED ->
                    OwnWords.refusal(drawing.method(), drawing.message(), texts.language())
                            .orElseGet(() -> texts.text("figure.refused", method));
            case CRASHED -> texts.text("note.crashed", method, drawing.message());
            case CUT -> texts.text("figure.cut", method, drawing.steps());
            case ENDED -> ended(drawing, named);
        };
    }

    private String ended(FigureDrawing drawing, boolean named) {
        String method = OwnWords.called(drawing.method(), texts.language());
        boolean arc = model.state().drawn().figure() instanceof ArcFigure;
        if (arc && !drawing.judged())
            return texts.text("figure.unjudged", method, model.mostJudged());
        return named ? method : "";
    }

    private List<PlanePoint> points() {
        var points = new ArrayList<PlanePoint>();
        model.state().scene().figure().grips().forEach((grip, at) -> points.add(point(grip, at)));
        return points;
    }

    private PlanePoint point(String grip, RasterPoint at) {
        String kind = grip.startsWith("point.") ? "grip.point" : grip;
        String said =
                texts.text("figure." + kind) + " " + Shown.point(at.x(), at.y(), texts.locale());
        boolean center = grip.equals(ArcFigure.CENTER);
        return new PlanePoint(
                grip,
                at.x(),
                at.y(),
                center ? PlanePoint.HandleShape.CIRCLE : PlanePoint.HandleShape.SQUARE,
                "",
                texts.text("figure.keys", said));
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
            model.move(point, x, y);
        }

        @Override
        public void add(double x, double y) {
            model.add(x, y);
        }

        @Override
        public void remove(String point) {
            model.remove(point);
        }
    }
}
