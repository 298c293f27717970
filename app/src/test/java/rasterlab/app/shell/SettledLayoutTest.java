package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BorderLayout;
import java.awt.Container;
import java.awt.Dimension;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

class SettledLayoutTest {
    /** Wants the area of 40×40, as high as it takes at the width it has. */
    private static final class Wrapped extends JPanel {
        @Override
        public Dimension getPreferredSize() {
            return new Dimension(40, getWidth() == 0 ? 40 : 1600 / getWidth());
        }
    }

    /** Counts how often it is laid out. */
    private static final class Counted extends JPanel {
        private int layouts;

        Counted() {
            super(new BorderLayout());
        }

        @Override
        public void doLayout() {
            layouts++;
            super.doLayout();
        }
    }

    @Test
    void partThatWantsAnotherHeightOnceItIsNarrowGetsIt() {
        var wrapped = new Wrapped();
        JPanel inner = around(wrapped);
        var outer = new JPanel(new BorderLayout());
        outer.add(inner, BorderLayout.NORTH);
        inner.setSize(20, 40); // Only the part in it moves in the first pass.
        settle(outer, 20, 500);
        assertEquals(new Dimension(20, 80), wrapped.getSize());
        assertEquals(new Dimension(20, 80), inner.getSize());
    }

    @Test
    void onlyWhereSomethingMovedIsLaidOutAgain() {
        var rests = new Counted();
        rests.add(new JPanel());
        var moves = new Counted();
        moves.add(new Wrapped(), BorderLayout.NORTH);
        var both = new JPanel(null);
        both.add(rests);
        both.add(moves);
        settle(rests, 30, 30);
        rests.layouts = 0;
        moves.setSize(20, 100);
        settle(both, 100, 100);
        assertEquals(1, rests.layouts);
        assertTrue(moves.layouts > 1, moves.layouts + " layouts");
    }

    @Test
    void whatIsResizedInALaterPassIsLaidOutAgain() {
        var filled = new JPanel();
        var below = new Counted();
        below.add(filled);
        settle(below, 20, 460); // What the first pass leaves it.
        var outer = new JPanel(new BorderLayout());
        outer.add(around(new Wrapped()), BorderLayout.NORTH);
        outer.add(below);
        settle(outer, 20, 500);
        assertEquals(new Dimension(20, 420), below.getSize());
        assertEquals(below.getSize(), filled.getSize());
    }

    @Test
    void layoutThatNeverRestsEnds() {
        var restless =
                new JPanel(null) {
                    @Override
                    public void doLayout() {
                        getComponent(0).setLocation(getComponent(0).getX() + 1, 0);
                    }
                };
        restless.add(new JPanel());
        settle(restless, 10, 10);
        assertEquals(4, restless.getComponent(0).getX(), "layouts");
    }

    private static JPanel around(Wrapped wrapped) {
        var around = new JPanel(new BorderLayout());
        around.add(wrapped, BorderLayout.NORTH);
        return around;
    }

    private static void settle(Container container, int width, int height) {
        container.setSize(width, height);
        SettledLayout.of(container);
    }
}
