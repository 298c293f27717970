package rasterlab.app.visibility;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.chart.ChartSize;
import rasterlab.app.language.Texts;
import rasterlab.app.plan.least.MagnifiedDifference;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.scene.Vase;

/** Shows the finished picture and turns the eye by keys, drag and wheel. */
final class VisibilityStage extends SelfDrawn implements Settling {
    private static final long serialVersionUID = 1L;

    /** Radians that one view unit of a drag turns. */
    private static final double DRAG = Math.PI / 400;

    private static final double WHEEL = 1.08;
    private static final double ZOOM = 1.25;

    /** View units that a mouse may move between press and release of a click. */
    private static final int CLICK = 3;

    private final transient VisibilityLabModel model;
    private final transient Texts texts;
    private final CountingPanel counting;
    private final JLabel pointed = new JLabel();

    VisibilityStage(VisibilityLabModel model, Texts texts) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        this.texts = texts;
        counting = new CountingPanel(model, texts);
        add(counting);
        addReadOut();
        setName("stage");
        setFocusable(true);
        setOpaque(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
        getAccessibleContext().setAccessibleName(texts.text("stage"));
        getAccessibleContext().setAccessibleDescription(texts.text("stage.hint"));
        var mouse = new Turning();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        repaintOnFocus();
        bind(KeyEvent.VK_UP, 0, Vase.PHI_STEP);
        bind(KeyEvent.VK_DOWN, 0, -Vase.PHI_STEP);
        bind(KeyEvent.VK_LEFT, -Vase.THETA_STEP, 0);
        bind(KeyEvent.VK_RIGHT, Vase.THETA_STEP, 0);
        bindPixel(KeyEvent.VK_UP, 0, -1);
        bindPixel(KeyEvent.VK_DOWN, 0, 1);
        bindPixel(KeyEvent.VK_LEFT, -1, 0);
        bindPixel(KeyEvent.VK_RIGHT, 1, 0);
        for (String key : new String[] {"typed +", "typed ="})
            KeyBinding.whenFocused(this, KeyStroke.getKeyStroke(key), () -> zoom(ZOOM));
        KeyBinding.whenFocused(this, KeyStroke.getKeyStroke("typed -"), () -> zoom(1 / ZOOM));
    }

    private void addReadOut() {
        pointed.setOpaque(true);
        pointed.setBackground(StageColors.now().ground());
        pointed.setForeground(StageColors.now().ink());
        pointed.setBorder(BorderFactory.createEmptyBorder(2, 5, 2, 5));
        pointed.setVisible(false);
        pointed.setName("pointed");
        add(pointed);
    }

    private void bindPixel(int key, int right, int down) {
        KeyBinding.whenFocused(
                this,
                KeyStroke.getKeyStroke(key, InputEvent.SHIFT_DOWN_MASK),
                () -> model.movePixel(right, down));
    }

    private void bind(int key, double dTheta, double dPhi) {
        KeyBinding.whenFocused(
                this, KeyStroke.getKeyStroke(key, 0), () -> change(() -> model.turn(dTheta, dPhi)));
    }

    private void zoom(double factor) {
        change(() -> model.zoom(factor));
    }

    /** A change that is over at once, after which wrong pixels are counted as after a drag. */
    private void change(Runnable change) {
        change.run();
        model.count();
    }

    @Override
    public void settle() throws InterruptedException {
        model.settle();
    }

    /** The pictures fill the stage, in the screen's own dots. */
    @Override
    public void doLayout() {
        double scale = DevicePixels.scale(this);
        model.resize(DevicePixels.count(getWidth(), scale), DevicePixels.count(getHeight(), scale));
        askForChart();
        Dimension size = counting.getPreferredSize();
        counting.setBounds(
                (getWidth() - size.width) / 2,
                (getHeight() - size.height) / 2,
                size.width,
                size.height);
        Dimension place = pointed.getPreferredSize();
        pointed.setBounds(8, getHeight() - place.height - 8, place.width, place.height);
    }

    /** Shows the model's present state. */
    void refresh() {
        VisibilityChoice choice = model.state().choice();
        askForChart();
        counting.refresh(choice.view());
        pointed.setVisible(pointed.isVisible() && !choice.view().isChart());
        revalidate();
        repaint();
    }

    /** Asks for the chart that is to be shown, in the stage's size, unless it is there. */
    private void askForChart() {
        StageView view = model.state().choice().view();
        if (!view.isChart() || getWidth() < 1 || getHeight() < 1) return;
        double type = UIScale.getUserScaleFactor();
        ChartSize size =
                view == StageView.GROWTH
                        ? GrowthChart.filling(getWidth(), getHeight(), type)
                        : ChartSize.filling(getWidth(), getHeight(), type);
        var colors = StageColors.now();
        model.charts().ask(new ChartStudies.ChartRequest(view, texts.language(), colors, size));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 600);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        paintAll(g);
        g.dispose();
        paintFocus((Graphics2D) graphics.create());
    }

    private void paintAll(Graphics2D g) {
        g.setColor(StageColors.now().ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        VisibilityLabState state = model.state();
        if (state.choice().view().isChart()) paintChart(g);
        else paintPictures(g, state);
    }

    /** The chart, or the pictures with what lies over them, as an SVG document. */
    SvgDrawing svg() {
        boolean charted = model.state().choice().view().isChart();
        return model.charts()
                .chart()
                .filter(chart -> charted)
                .map(VisibilityStage::svg)
                .orElseGet(() -> SvgPicture.of(this, this::paintAll));
    }

    private static SvgDrawing svg(ChartStudies.FinishedChart chart) {
        return () -> new String(chart.svg().get(), StandardCharsets.UTF_8);
    }

    /** Paints the chart as large as it fits, in the middle. */
    private void paintChart(Graphics2D g) {
        Optional<ChartStudies.FinishedChart> chart = model.charts().chart();
        if (chart.isEmpty()) return;
        var image = chart.get().image();
        double fit =
                Math.min(
                        (double) getWidth() / image.getWidth(),
                        (double) getHeight() / image.getHeight());
        int width = (int) (fit * image.getWidth());
        int height = (int) (fit * image.getHeight());
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.drawImage(
                image, (getWidth() - width) / 2, (getHeight() - height) / 2, width, height, null);
    }

    private void paintPictures(Graphics2D g, VisibilityLabState state) {
        state.picture()
                .ifPresent(picture -> paintPicture(g, picture, state.difference(), state, false));
        if (state.other().isPresent() && !state.choice().comparison().isEmpty())
            paintPicture(g, state.other().get(), state.otherDifference(), state, true);
        sayProblem(g, state);
    }

    private void paintPicture(
            Graphics2D g,
            Picture picture,
            Optional<Compared> difference,
            VisibilityLabState state,
            boolean second) {
        double scale = DevicePixels.scale(this);
        double left = second ? secondLeft(picture, scale) : 0;
        boolean marked = state.marked();
        var over = (Graphics2D) g.create();
        over.translate(left, 0);
        DevicePixels.paint(
                (Graphics2D) over.create(),
                model.bills()
                        .magnified(state)
                        .map(MagnifiedDifference::raster)
                        .or(() -> difference.filter(f -> marked).map(f -> f.difference().mask()))
                        .orElse(picture.raster())
                        .image());
        over.clipRect(
                0,
                0,
                (int) Math.ceil(picture.raster().width() / scale),
                (int) Math.ceil(picture.raster().height() / scale));
        var overlay = new StageOverlay(over, scale);
        if (!second && state.drawn().isPresent() && state.step() != Frame.ALL)
            overlay.step(state.drawn().get(), state.step());
        state.chosen()
                .filter(pixel -> pixel.second() == second)
                .ifPresent(pixel -> overlay.pixel(pixel.x(), pixel.y()));
        if (!state.choice().comparison().isEmpty())
            overlay.name(picture.request().visibility(), texts.language());
        picture.refusal().ifPresent(message -> refuse(overlay, over, picture, message, scale));
        picture.lent().ifPresent(lender -> tellLender(overlay, over, picture, lender, scale));
        over.dispose();
    }

    /** Where the second picture begins, in view units; between the two is a gap. */
    private static double secondLeft(Picture picture, double scale) {
        return (picture.raster().width() + StagePictures.GAP) / scale;
    }

    /** Says why the method drew nothing. */
    private void refuse(
            StageOverlay overlay, Graphics2D g, Picture picture, String message, double scale) {
        String said = VisibilityReadings.refusal(picture.request().visibility(), message, texts);
        int width = (int) (picture.raster().width() / scale);
        say(overlay, g, said, width, getHeight() / 2);
    }

    /** Says whose depths are shown, below where a method's name stands. */
    private void tellLender(
            StageOverlay overlay, Graphics2D g, Picture picture, String lender, double scale) {
        String called = OwnWords.called(picture.request().visibility(), texts.language());
        String said = texts.text("depths.lent", lender, called);
        int width = (int) (picture.raster().width() / scale);
        overlay.sentenceBelow(lines(said, width, g), 24, 2 * g.getFontMetrics().getHeight());
    }

    private void sayProblem(Graphics2D g, VisibilityLabState state) {
        String said = new VisibilityReadings(model, texts).overStage();
        if (!said.isEmpty())
            say(
                    new StageOverlay(g, 1),
                    g,
                    said,
                    getWidth(),
                    getHeight() - pointed.getPreferredSize().height - 16);
    }

    private static void say(
            StageOverlay overlay, Graphics2D g, String sentence, int width, int bottom) {
        overlay.sentence(lines(sentence, width, g), 24, bottom);
    }

    private static List<String> lines(String sentence, int width, Graphics2D g) {
        return Wrapping.lines(sentence, width - 48, g.getFontMetrics()::stringWidth);
    }

    /** The pixel under a place of the stage, of whichever picture lies there. */
    private Optional<ChosenPixel> pixelAt(Point view) {
        VisibilityLabState state = model.state();
        if (state.picture().isEmpty() || state.choice().view().isChart()) return Optional.empty();
        double scale = DevicePixels.scale(this);
        Picture first = state.picture().get();
        double left = secondLeft(first, scale);
        boolean second = state.other().isPresent() && view.x >= left;
        int x = (int) Math.floor((view.x - (second ? left : 0)) * scale);
        int y = (int) Math.floor(view.y * scale);
        return first.raster().contains(x, y)
                ? Optional.of(new ChosenPixel(second, x, y))
                : Optional.empty();
    }

    private void point(Point view) {
        Optional<ChosenPixel> pixel = pixelAt(view);
        pointed.setVisible(pixel.isPresent());
        if (pixel.isEmpty()) return;
        VisibilityLabState state = model.state();
        Picture picture = pixel.get().second() ? state.other().get() : state.picture().get();
        int argb = picture.raster().argb(pixel.get().x(), pixel.get().y());
        pointed.setText(
                texts.text(
                        "pointed",
                        Integer.toString(pixel.get().x()),
                        Integer.toString(pixel.get().y()),
                        (argb >> 16 & 255) + " " + (argb >> 8 & 255) + " " + (argb & 255)));
        revalidate();
    }

    /** Paints blue between two white lines, so that it is seen on any picture. */
    private void paintFocus(Graphics2D g) {
        if (showsFocus()) {
            g.setColor(Color.WHITE);
            g.setStroke(new BasicStroke(4));
            g.drawRect(2, 2, getWidth() - 4, getHeight() - 4);
            g.setColor(StageColors.LIGHT.focus());
            g.setStroke(new BasicStroke(2));
            g.drawRect(2, 2, getWidth() - 4, getHeight() - 4);
        }
        g.dispose();
    }

    /** One drag turns the eye as one change for undo; a click chooses a pixel. */
    private final class Turning extends MouseAdapter {
        private Point last = new Point();
        private Point pressed = new Point();
        private boolean moved;

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            last = e.getPoint();
            pressed = e.getPoint();
            moved = false;
            model.beginDrag();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            if (model.state().choice().view().isChart()) return;
            moved |= pressed.distance(e.getPoint()) > CLICK;
            if (!moved) return;
            model.turn((last.x - e.getX()) * DRAG, (last.y - e.getY()) * DRAG);
            last = e.getPoint();
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            model.endDrag();
            if (!moved) pixelAt(e.getPoint()).ifPresent(model::choosePixel);
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            point(e.getPoint());
        }

        @Override
        public void mouseExited(MouseEvent e) {
            pointed.setVisible(false);
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            if (model.state().choice().view().isChart()) return;
            double turned = e.getPreciseWheelRotation();
            if (e.isControlDown()) zoom(Math.pow(ZOOM, -turned));
            else change(() -> model.dolly(Math.pow(WHEEL, turned)));
        }
    }
}
