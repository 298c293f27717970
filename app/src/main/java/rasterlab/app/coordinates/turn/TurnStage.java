package rasterlab.app.coordinates.turn;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.UIManager;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.language.Texts;

/** The way round with the point that can be dragged, and the chart of the drift beside it. */
final class TurnStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private static final int GAP = 8;

    /** The chart's width where there is little of it. */
    private static final int CHART = 440;

    /** The least side of the way beside the chart, in sizes of the type. */
    private static final int WAY = 10;

    /** The least part of the stage's width that the way has beside the chart. */
    private static final double WAY_BESIDE = 0.4;

    private final transient TurnLabModel model;
    private final transient Texts texts;
    private final PlaneView way;
    private final DriftChart chart;
    private final JPanel turns = new JPanel(new FlowRows(6));
    private final JToggleButton showsWay;
    private final JToggleButton showsChart;

    TurnStage(TurnLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(null);
        this.model = model;
        this.texts = texts;
        setOpaque(false);
        way =
                new PlaneView(
                        PlaneAxes.GEOMETRY,
                        Texts.of("canvas", texts.language()),
                        texts.text("stage"),
                        new Edits(),
                        model::settle,
                        onFailure);
        chart = new DriftChart(texts);
        showsWay = new JToggleButton(texts.text("turns.way"), true);
        showsChart = new JToggleButton(texts.text("turns.chart"));
        add(way);
        add(chart);
        add(turns);
        var one = new ButtonGroup();
        for (JToggleButton each : List.of(showsWay, showsChart)) {
            one.add(each);
            turns.add(each);
            each.addActionListener(e -> revalidate());
        }
        showsWay.setName("turn.way");
        showsChart.setName("turn.chart");
        refresh();
    }

    /**
     * Places the parts beside each other, one above the other in a high stage, or in turn in a
     * small one.
     */
    @Override
    public void doLayout() {
        int width = getWidth();
        int height = getHeight();
        int least = WAY * UIManager.getFont("Label.font").getSize();
        Dimension needed = chart.getMinimumSize();
        double wide = Math.max(least, WAY_BESIDE * width);
        boolean beside = width - GAP - needed.width >= wide && height >= needed.height;
        boolean above = height - GAP >= 2 * Math.max(least, needed.height) && width >= needed.width;
        boolean inTurn = !beside && !above;
        turns.setVisible(inTurn);
        way.setVisible(!inTurn || showsWay.isSelected());
        chart.setVisible(!inTurn || showsChart.isSelected());
        if (inTurn) {
            Dimension buttons = turns.getPreferredSize();
            turns.setBounds(0, 0, width, buttons.height);
            int top = buttons.height + GAP;
            for (Component each : List.of(way, chart)) each.setBounds(0, top, width, height - top);
        } else if (beside && (width >= height || !above)) {
            int usual = Math.max(width / 2, Math.min(width * 3 / 5, CHART));
            int most = Math.min(Math.max(usual, needed.width), width - GAP - least);
            way.setBounds(0, 0, width - most - GAP, height);
            chart.setBounds(width - most, 0, most, height);
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

    /** The way and the chart, without the ring around the point, as an SVG document. */
    SvgDrawing svg() {
        return SvgPicture.of(
                getWidth(),
                getHeight(),
                g -> {
                    if (way.isVisible()) SvgPicture.within(way.getBounds(), g, way.drawing());
                    if (chart.isVisible()) SvgPicture.within(chart.getBounds(), g, chart::draw);
                });
    }

    void focusPoint() {
        way.focusPoint();
    }

    void refresh() {
        TurnScene scene = model.scene();
        Figure figure = TurnFigure.of(scene, model.step(), texts.language());
        Rectangle2D everything = MarkBounds.around(figure.marks());
        int begun = scene.known() ? 1 : 0;
        way.show(
                figure, List.of(point()), note(scene), everything, 2 * model.arrangement() + begun);
        chart.show(scene, model.busy());
    }

    private String note(TurnScene scene) {
        String refusal = TurnInspector.refusal(model, texts);
        if (!refusal.isEmpty()) return refusal;
        int times = scene.choice().times();
        return times > TurnScene.MOST_TURNS
                ? texts.text("note.first", TurnScene.MOST_TURNS, times)
                : "";
    }

    private PlanePoint point() {
        TurnChoice choice = model.choice();
        return new PlanePoint(
                "handle.point",
                choice.x(),
                choice.y(),
                PlanePoint.HandleShape.CIRCLE,
                "",
                texts.text("point.said", Shown.point(choice.x(), choice.y(), texts.locale())));
    }

    /** Ends the thread that paints. */
    @Override
    public void close() {
        way.close();
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
