package rasterlab.app.row;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.language.Texts;

/** The bands of the row; a click, a drag or an arrow key chooses a pixel. */
final class RowStage extends SelfDrawn implements Settling {
    private static final long serialVersionUID = 1L;

    private final transient RowLabModel model;
    private final transient Texts texts;

    RowStage(RowLabModel model, Texts texts) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        this.texts = texts;
        setName("stage");
        setFocusable(true);
        setOpaque(true);
        getAccessibleContext().setAccessibleName(texts.text("stage"));
        getAccessibleContext().setAccessibleDescription(texts.text("stage.hint"));
        var mouse = new Choosing();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        repaintOnFocus();
        bind(KeyEvent.VK_LEFT, -1);
        bind(KeyEvent.VK_RIGHT, 1);
    }

    private void bind(int key, int by) {
        KeyBinding.whenFocused(
                this,
                KeyStroke.getKeyStroke(key, 0),
                () -> model.choosePixel(model.choice().pixel() + by));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 600);
    }

    /** The picture that is shown, as an SVG document. */
    SvgDrawing svg() {
        return SvgPicture.of(this, this::paintAll);
    }

    private void paintAll(Graphics2D g) {
        g.setColor(StageColors.now().ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        model.shown()
                .ifPresent(
                        scene -> new RowPainter(g, texts, model.choice(), scene, plan()).paint());
    }

    private RowPlan plan() {
        boolean pictured = model.shown().flatMap(RowScene::image).isPresent();
        return new RowPlan(getWidth(), getHeight(), pictured);
    }

    @Override
    public void settle() throws InterruptedException {
        model.settle();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        paintAll(g);
        frameFocus(g);
        g.dispose();
    }

    private final class Choosing extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            if (!plan().inColumn(e.getX())) choose(e);
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            choose(e);
        }

        private void choose(MouseEvent e) {
            model.choosePixel(plan().pixelAt(e.getX(), model.pixels()));
        }
    }
}
