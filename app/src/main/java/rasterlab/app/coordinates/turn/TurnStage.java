package rasterlab.app.coordinates.turn;

import java.awt.Dimension;
import java.awt.geom.Rectangle2D;
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
import rasterlab.app.language.Texts;

/** The way round with the point that can be dragged, and the chart of the drift beside it. */
final class TurnStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private static final int GAP = 8;

    private final transient TurnLabModel model;
    private final transient Texts texts;
    private final PlaneView way;
    private final PlaneView chart;

    TurnStage(TurnLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(null);
        this.model = model;
        this.texts = texts;
        setOpaque(false);
        way = view(PlaneAxes.GEOMETRY, "stage", onFailure);
        chart = view(PlaneAxes.GRAPH, "stage.chart", onFailure);
        refresh();
    }

    private PlaneView view(PlaneAxes axes, String name, Consumer<Throwable> onFailure) {
        var view =
                new PlaneView(
                        axes,
                        Texts.of("canvas", texts.language()),
                        texts.text(name),
                        new Edits(),
                        model::settle,
                        onFailure);
        view.setName(name);
        add(view);
        return view;
    }

    /** Beside each other, or one above the other in a high stage. */
    @Override
    public void doLayout() {
        int width = getWidth();
        int height = getHeight();
        if (width >= height) {
            int half = (width - GAP) / 2;
            way.setBounds(0, 0, half, height);
            chart.setBounds(width - half, 0, half, height);
        } else {
            int half = (height - GAP) / 2;
            way.setBounds(0, 0, width, half);
            chart.setBounds(0, height - half, width, half);
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return way.getPreferredSize();
    }

    PlaneView shown() {
        return way;
    }

    void focusPoint() {
        way.focusPoint();
    }

    void refresh() {
        TurnScene scene = model.scene();
        Figure figure = TurnFigures.way(scene, model.step());
        Rectangle2D everything = Box.around(figure.marks());
        int begun = scene.exact() == null ? 0 : 1;
        way.show(
                figure, List.of(point()), note(scene), everything, 2 * model.arrangement() + begun);
        Figure drift =
                TurnFigures.chart(scene, texts.text("chart.turns"), texts.text("chart.error"));
        var box = new Rectangle2D.Double(0, TurnFigures.LOWEST - 0.4, 8, 18.8);
        chart.show(drift, List.of(), model.busy() ? texts.text("busy") : "", box, 0);
    }

    private String note(TurnScene scene) {
        int times = scene.choice().times();
        return times > TurnScene.MOST_TURNS
                ? texts.text("note.first", TurnScene.MOST_TURNS, times)
                : "";
    }

    private PlanePoint point() {
        TurnChoice choice = model.choice();
        return new PlanePoint(
                "point",
                choice.x(),
                choice.y(),
                PlanePoint.Form.CIRCLE,
                "",
                texts.text("point.said", Shown.point(choice.x(), choice.y(), texts.locale())));
    }

    /** Ends the threads that paint. */
    @Override
    public void close() {
        way.close();
        chart.close();
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
            model.movePoint(x, y);
        }
    }
}
