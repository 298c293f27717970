package rasterlab.app.light.panel;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.LightLabState;
import rasterlab.app.light.LitBody;
import rasterlab.app.light.step.OwnSteps;
import rasterlab.app.model.EmptyPicture;
import rasterlab.app.plan.least.PlanReadings;

/** Three shadings side by side above the profile; lamps, line and point are dragged. */
public final class LightStage extends SelfDrawn implements Settling {
    private static final long serialVersionUID = 1L;

    /** Radians that one view unit of a drag turns. */
    private static final double DRAG = Math.PI / 400;

    private static final double KEY = 0.03 * Math.PI;
    private static final double WHEEL = 1.08;
    private static final double ZOOM = 1.25;

    /** Pixels and depth factor by which a key moves a lamp. */
    private static final double NUDGE = 6;

    private static final double AWAY = 1.04;

    private final transient LightLabModel model;
    private final transient Texts texts;
    private final transient LightGrips grips;
    private final transient PlanReadings readings;

    public LightStage(LightLabModel model, Texts texts) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        this.texts = texts;
        readings = new PlanReadings(texts.language());
        grips = new LightGrips(model);
        setName("stage");
        setFocusable(true);
        setOpaque(true);
        getAccessibleContext().setAccessibleName(texts.text("stage"));
        getAccessibleContext().setAccessibleDescription(texts.text("stage.hint"));
        var mouse = new Dragging();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        repaintOnFocus();
        bindKeys();
    }

    private void bindKeys() {
        bind(KeyEvent.VK_UP, 0, () -> model.turn(0, -KEY));
        bind(KeyEvent.VK_DOWN, 0, () -> model.turn(0, KEY));
        bind(KeyEvent.VK_LEFT, 0, () -> model.turn(-KEY, 0));
        bind(KeyEvent.VK_RIGHT, 0, () -> model.turn(KEY, 0));
        int shift = InputEvent.SHIFT_DOWN_MASK;
        bind(KeyEvent.VK_UP, shift, () -> grips.nudge(0, -NUDGE, 1));
        bind(KeyEvent.VK_DOWN, shift, () -> grips.nudge(0, NUDGE, 1));
        bind(KeyEvent.VK_LEFT, shift, () -> grips.nudge(-NUDGE, 0, 1));
        bind(KeyEvent.VK_RIGHT, shift, () -> grips.nudge(NUDGE, 0, 1));
        bind(KeyEvent.VK_PAGE_UP, shift, () -> grips.nudge(0, 0, AWAY));
        bind(KeyEvent.VK_PAGE_DOWN, shift, () -> grips.nudge(0, 0, 1 / AWAY));
        for (String key : new String[] {"typed +", "typed ="})
            KeyBinding.whenFocused(this, KeyStroke.getKeyStroke(key), () -> zoom(ZOOM));
        KeyBinding.whenFocused(this, KeyStroke.getKeyStroke("typed -"), () -> zoom(1 / ZOOM));
    }

    private void bind(int key, int modifiers, Runnable action) {
        KeyBinding.whenFocused(this, KeyStroke.getKeyStroke(key, modifiers), action);
    }

    private void zoom(double factor) {
        model.choose(choice -> choice.zoomed(factor));
    }

    private StagePlan plan() {
        return new StagePlan(
                getWidth(), getHeight(), getFontMetrics(PictureType.in(getSize())).getHeight());
    }

    @Override
    public void settle() throws InterruptedException {
        model.settle();
    }

    /** Places each picture in the screen's own dots. */
    @Override
    public void doLayout() {
        double scale = DevicePixels.scale(this);
        var picture = plan().picture(0);
        model.resize(
                DevicePixels.count(picture.width, scale),
                DevicePixels.count(picture.height, scale));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 600);
    }

    /** The stage as an SVG document with the pictures in it. */
    public SvgDrawing svg() {
        return SvgPicture.of(this, this::paintAll);
    }

    private void paintAll(Graphics2D g) {
        g.setColor(StageColors.now().margin());
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setFont(PictureType.in(getSize()));
        LightLabState state = model.state();
        double scale = DevicePixels.scale(this);
        Optional<OwnSteps> steps = state.drawn().flatMap(LightFrame.DrawnFrame::steps);
        int step = steps.map(all -> model.walk.step(all.count())).orElse(0);
        boolean within = steps.filter(all -> step > 0 && step < all.count()).isPresent();
        state.drawn()
                .ifPresent(
                        drawn -> {
                            var painter =
                                    new LightPainter(
                                            g, texts, drawn.upTo(step), state.choice(), scale);
                            painter.paint(plan());
                            if (within) painter.ring(steps.get().point(step), plan());
                        });
        String said =
                state.problem().isEmpty()
                        ? state.note().map(note -> note.in(texts.language())).orElse("")
                        : texts.text(
                                "problem",
                                Complaints.translated(texts.language(), state.problem()));
        if (said.isEmpty() && within) said = steps.get().words(step, texts);
        else if (said.isEmpty() && (steps.isEmpty() || step > 0))
            said =
                    state.drawn()
                            .flatMap(LightFrame.DrawnFrame::own)
                            .map(told -> told.in(texts))
                            .orElse("");
        if (said.isEmpty())
            said =
                    state.drawn()
                            .flatMap(LightFrame.DrawnFrame::least)
                            .map(pair -> readings.difference(pair.difference()))
                            .orElse("");
        if (showsNothing(state)) said = (said + " " + texts.text("empty")).strip();
        if (!said.isEmpty())
            Plates.sentenceAbove(g, said, getWidth(), plan().picture(0).height - 12);
    }

    /** Whether every picture of a model has nothing of it. */
    private static boolean showsNothing(LightLabState state) {
        Optional<LitBody.OpenedScene> model =
                state.choice().body().opened().filter(one -> one.up().isPresent());
        return model.isPresent()
                && state.drawn().isPresent()
                && state.drawn().get().pictures().stream()
                        .allMatch(
                                picture ->
                                        EmptyPicture.is(
                                                picture.raster(),
                                                model.get().scene().backgroundRgb()));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        paintAll(g);
        frameFocus(g);
        g.dispose();
    }

    /** A drag on a grip moves it, elsewhere it turns the scene; each as one change for undo. */
    private final class Dragging extends MouseAdapter {
        private Point last = new Point();
        private Optional<LightGrip> held = Optional.empty();
        private boolean picture;

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            last = e.getPoint();
            held = grips.under(last, plan());
            picture = last.y < plan().picture(0).height;
            model.beginDrag();
            held.filter(grip -> grip.kind() == LightGrip.LightGripKind.LAMP)
                    .ifPresent(grip -> model.choose(choice -> choice.selecting(grip.index())));
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            if (held.isPresent()) grips.drag(held.get(), e.getPoint(), plan());
            else if (picture) model.turn((last.x - e.getX()) * DRAG, (last.y - e.getY()) * DRAG);
            last = e.getPoint();
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            model.endDrag();
            held = Optional.empty();
        }

        /** A double click puts the point there. */
        @Override
        public void mouseClicked(MouseEvent e) {
            if (e.getClickCount() == 2 && picture)
                grips.drag(new LightGrip(LightGrip.LightGripKind.POINT, 0), e.getPoint(), plan());
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            boolean grip = grips.under(e.getPoint(), plan()).isPresent();
            boolean above = e.getY() < plan().picture(0).height;
            int cursor =
                    grip ? Cursor.HAND_CURSOR : above ? Cursor.MOVE_CURSOR : Cursor.DEFAULT_CURSOR;
            setCursor(Cursor.getPredefinedCursor(cursor));
        }

        /** Moves the lamp under the pointer away, zooms with Ctrl, else moves the eye. */
        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            double turned = e.getPreciseWheelRotation();
            Optional<LightGrip> grip = grips.under(e.getPoint(), plan());
            if (grip.isPresent() && grip.get().kind() == LightGrip.LightGripKind.LAMP) {
                model.choose(choice -> choice.selecting(grip.get().index()));
                grips.nudge(0, 0, Math.pow(AWAY, turned));
            } else if (e.isControlDown()) zoom(Math.pow(ZOOM, -turned));
            else model.dolly(Math.pow(WHEEL, turned));
        }
    }
}
