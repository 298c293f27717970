package rasterlab.app.study;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.canvas.method.SecondaryText;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Texts;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.app.study.front.FrontChart;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/** The chart, painted in the background; its points can be clicked and walked with the arrows. */
final class ChartStage extends SelfDrawn implements Settling, AutoCloseable {
    private static final long serialVersionUID = 1L;

    /** A chart that is smaller than this, in its own type, is painted so large and made smaller. */
    private static final Dimension LEAST = new Dimension(560, 400);

    /** How near to a point a click must be, in the chart's own units. */
    private static final double NEAR = 14;

    /**
     * @param width in the chart's own units, in which its type has always the same size
     * @param height likewise
     * @param dots of the picture for each unit
     */
    private record StudyChartRequest(
            Study study,
            StudyCost cost,
            String level,
            int width,
            int height,
            double dots,
            StageColors colors) {}

    private record Painted(
            StudyChartRequest asked, BufferedImage image, List<FrontChart.PaintedPoint> spots) {}

    private final transient StudyLabModel model;
    private final transient Texts texts;
    private final transient TopicNames called;
    private final transient LatestOnly<StudyChartRequest, Painted> painter;
    private transient Optional<Painted> painted = Optional.empty();
    private transient Optional<StudyChartRequest> asked = Optional.empty();

    /**
     * @param onFailure told what painting threw, on any thread
     */
    ChartStage(StudyLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        this.texts = texts;
        called = TopicNames.in(texts.language());
        painter =
                new LatestOnly<>(
                        "chart",
                        (question, cancelled) -> painted(question),
                        (question, answer) -> EventQueue.invokeLater(() -> show(answer)),
                        onFailure);
        setName("chart");
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        getAccessibleContext().setAccessibleName(texts.text("chart"));
        addMouseListener(
                new MouseAdapter() {
                    @Override
                    public void mousePressed(MouseEvent e) {
                        requestFocusInWindow();
                        near(e.getX(), e.getY()).ifPresent(model::choose);
                    }
                });
        addComponentListener(
                new ComponentAdapter() {
                    @Override
                    public void componentResized(ComponentEvent e) {
                        refresh();
                    }
                });
        KeyBinding.whenFocused(this, KeyStroke.getKeyStroke("RIGHT"), () -> walk(1));
        KeyBinding.whenFocused(this, KeyStroke.getKeyStroke("LEFT"), () -> walk(-1));
    }

    /**
     * @param x view units
     * @param y view units
     */
    private Optional<Measurement> near(int x, int y) {
        return painted.flatMap(
                chart ->
                        nearest(
                                chart.spots(),
                                (double) x * chart.asked().width() / getWidth(),
                                (double) y * chart.asked().height() / getHeight()));
    }

    private static Optional<Measurement> nearest(
            List<FrontChart.PaintedPoint> spots, double x, double y) {
        return spots.stream()
                .filter(spot -> Math.hypot(spot.x() - x, spot.y() - y) <= NEAR)
                .min(Comparator.comparingDouble(spot -> Math.hypot(spot.x() - x, spot.y() - y)))
                .map(FrontChart.PaintedPoint::point);
    }

    /** Goes to the next dearer or cheaper point. */
    private void walk(int steps) {
        List<Measurement> points =
                painted.map(Painted::spots).orElse(List.of()).stream()
                        .map(FrontChart.PaintedPoint::point)
                        .sorted(Comparator.comparingDouble(p -> p.cost().medianNanos()))
                        .toList();
        if (points.isEmpty()) return;
        List<String> methods = points.stream().map(Measurement::method).toList();
        int now =
                model.state()
                        .point()
                        .map(one -> methods.indexOf(one.method()))
                        .filter(place -> place >= 0)
                        .orElse(steps > 0 ? -1 : 0);
        model.choose(points.get(Math.floorMod(now + steps, points.size())));
    }

    /** Asks for the picture of the present study and size, unless it is there. */
    void refresh() {
        Optional<StudyChartRequest> wanted =
                model.state()
                        .shownStudy()
                        .filter(study -> getWidth() > 0 && getHeight() > 0)
                        .flatMap(
                                study ->
                                        model.state()
                                                .shownLevel()
                                                .map(level -> question(study, level)));
        if (!wanted.equals(asked)) {
            asked = wanted;
            if (wanted.isEmpty()) painted = Optional.empty();
            else painter.ask(wanted.get());
        }
        repaint();
    }

    private StudyChartRequest question(Study study, String level) {
        double type = type(getWidth(), getHeight(), UIScale.getUserScaleFactor());
        return new StudyChartRequest(
                study,
                model.state().view().cost().orElse(StudyCost.TIME),
                level,
                (int) Math.round(getWidth() / type),
                (int) Math.round(getHeight() / type),
                Math.max(1, type),
                StageColors.now());
    }

    /**
     * How much larger than usual the chart's type is.
     *
     * @param wanted the window's type, 1 for the usual size
     */
    static double type(int width, int height, double wanted) {
        return Math.min(
                wanted, Math.min((double) width / LEAST.width, (double) height / LEAST.height));
    }

    private Painted painted(StudyChartRequest question) {
        var colors = question.colors();
        var chart =
                new FrontChart(
                        question.study(),
                        question.level(),
                        question.cost().words(texts.language()),
                        ChartLook.on(colors));
        var image =
                new BufferedImage(
                        (int) Math.round(question.width() * question.dots()),
                        (int) Math.round(question.height() * question.dots()),
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(question.dots(), question.dots());
        g.setColor(colors.ground());
        g.fillRect(0, 0, question.width() + 1, question.height() + 1);
        chart.paint(g, question.width(), question.height());
        g.dispose();
        return new Painted(question, image, chart.spots());
    }

    private void show(Painted chart) {
        painted = Optional.of(chart);
        repaint();
    }

    @Override
    public void settle() throws InterruptedException {
        painter.settle();
    }

    @Override
    public void close() {
        painter.close();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(StageColors.now().ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        if (painted.isPresent()) paint(g, painted.get());
        else paintHint(g);
        g.setColor(UIManager.getColor("Component.borderColor"));
        if (showsFocus()) g.setColor(StageColors.now().focus());
        g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
        g.dispose();
    }

    private void paint(Graphics2D g, Painted chart) {
        var inChart = (Graphics2D) g.create();
        inChart.drawImage(chart.image(), 0, 0, getWidth(), getHeight(), null);
        inChart.scale(
                (double) getWidth() / chart.asked().width(),
                (double) getHeight() / chart.asked().height());
        inChart.setColor(StageColors.now().ink());
        inChart.setStroke(new BasicStroke(2));
        Optional<String> marked = model.state().point().map(Measurement::method);
        for (FrontChart.PaintedPoint spot : chart.spots())
            if (marked.filter(spot.point().method()::equals).isPresent())
                inChart.draw(new Ellipse2D.Double(spot.x() - 10, spot.y() - 10, 20, 20));
        inChart.dispose();
    }

    private void paintHint(Graphics2D g) {
        g.setFont(UIManager.getFont("Label.font").deriveFont(UIScale.scale(16f)));
        g.setColor(SecondaryText.on(StageColors.now().ground()));
        FontMetrics metrics = g.getFontMetrics();
        String key = model.state().work().running() ? "hint.measuring" : "hint.measure";
        List<String> lines =
                Wrapping.lines(
                        texts.text(key, called.topic(model.state().topic().name())),
                        getWidth() * 2 / 3,
                        metrics::stringWidth);
        int y = (getHeight() - lines.size() * metrics.getHeight()) / 2 + metrics.getAscent();
        for (String line : lines) {
            g.drawString(line, (getWidth() - metrics.stringWidth(line)) / 2, y);
            y += metrics.getHeight();
        }
    }
}
