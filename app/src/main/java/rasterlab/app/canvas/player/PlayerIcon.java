package rasterlab.app.canvas.player;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;
import javax.swing.UIManager;

/** The signs on the step player's buttons, drawn as shapes so that they scale. */
enum PlayerIcon {
    TO_START("|<"),
    BACK("<|"),
    PLAY("P"),
    PAUSE("||"),
    FORWARD("|>"),
    TO_END(">|");

    private final String sign;

    PlayerIcon(String sign) {
        this.sign = sign;
    }

    Icon icon() {
        return new Sign(sign);
    }

    private static final class Sign extends FlatAbstractIcon {
        private final String sign;

        Sign(String sign) {
            super(16, 16, null);
            this.sign = sign;
        }

        @Override
        protected void paintIcon(Component c, Graphics2D g) {
            g.setColor(
                    c.isEnabled() ? c.getForeground() : UIManager.getColor("Button.disabledText"));
            switch (sign) {
                case "|<" -> {
                    bar(g, 2);
                    triangle(g, 14, 5);
                }
                case "<|" -> {
                    triangle(g, 9, 1);
                    bar(g, 11);
                }
                case "P" -> triangle(g, 3, 14);
                case "||" -> {
                    bar(g, 4);
                    bar(g, 9);
                }
                case "|>" -> {
                    bar(g, 3);
                    triangle(g, 7, 15);
                }
                default -> {
                    triangle(g, 2, 11);
                    bar(g, 12);
                }
            }
        }

        private static void bar(Graphics2D g, double x) {
            g.fill(new Rectangle2D.Double(x, 2.5, 2.5, 11));
        }

        /**
         * Draws a triangle whose upright side is at {@code base} and whose tip is at {@code tip}.
         */
        private static void triangle(Graphics2D g, double base, double tip) {
            var path = new Path2D.Double();
            path.moveTo(base, 2.5);
            path.lineTo(tip, 8);
            path.lineTo(base, 13.5);
            path.closePath();
            g.fill(path);
        }
    }
}
