package rasterlab.app.canvas.lab;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.ActionEvent;
import java.awt.geom.Path2D;
import javax.swing.AbstractAction;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The narrow button between stage and inspector that hides the inspector and brings it back. */
final class InspectorSwitch extends JButton {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private boolean shown;

    InspectorSwitch(Language language, Runnable toggle) {
        texts = Texts.of("canvas", language);
        setName("inspector.switch");
        putClientProperty("JButton.buttonType", "toolBarButton");
        putClientProperty("FlatLaf.style", "margin: 0,1,0,1; minimumWidth: 0");
        setIcon(new Chevron());
        addActionListener(e -> toggle.run());
        getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
                .put(KeyStroke.getKeyStroke("F9"), "inspector");
        getActionMap()
                .put(
                        "inspector",
                        new AbstractAction() {
                            private static final long serialVersionUID = 1L;

                            @Override
                            public void actionPerformed(ActionEvent e) {
                                toggle.run();
                            }
                        });
    }

    /**
     * @param inspector whether the inspector is shown
     */
    void refresh(boolean inspector) {
        shown = inspector;
        String does = texts.text(shown ? "inspector.hide" : "inspector.show");
        setToolTipText(does);
        getAccessibleContext().setAccessibleName(does);
        repaint();
    }

    /** Points where the inspector goes. */
    private final class Chevron implements Icon {
        @Override
        public void paintIcon(Component c, Graphics g, int x, int y) {
            var g2 = (Graphics2D) g.create();
            g2.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            g2.setColor(c.getForeground());
            double tip = shown ? x + getIconWidth() - 1 : x + 1;
            double back = shown ? x + 1 : x + getIconWidth() - 1;
            var path = new Path2D.Double();
            path.moveTo(back, y + 1);
            path.lineTo(tip, y + getIconHeight() / 2.0);
            path.lineTo(back, y + getIconHeight() - 1);
            g2.setStroke(new BasicStroke(UIScale.scale(1f)));
            g2.draw(path);
            g2.dispose();
        }

        @Override
        public int getIconWidth() {
            return UIScale.scale(6);
        }

        @Override
        public int getIconHeight() {
            return UIScale.scale(11);
        }
    }
}
