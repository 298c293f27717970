package rasterlab.app.signmap;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.work.Background;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.signmap.SignMap;
import rasterlab.engine.signmap.SignSubject;

/** The sign maps of a topic's methods beside the window, which goes on meanwhile. */
public final class SignWindow extends JDialog {
    private static final long serialVersionUID = 1L;

    private static final int MOST_HIGH = 760;
    private static final int FIRST_HIGH = 480;

    private final Sheet sheet = new Sheet();
    private final transient Background work;

    private SignWindow(
            Window owner, SignSubject subject, Language language, Consumer<Throwable> onFailure) {
        super(owner, Texts.of("signmap", language).text("window", subject.name()));
        setName("sign-maps");
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        var scroll = new JScrollPane(sheet);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.getVerticalScrollBar().setUnitIncrement(16);
        setContentPane(scroll);
        KeyBinding.within(getRootPane(), KeyStroke.getKeyStroke("ESCAPE"), this::dispose);
        work = new Background("sign maps", EventQueue::invokeLater, onFailure);
        pack();
        setLocationRelativeTo(owner);
        sheet.requestFocusInWindow();
        var look = ChartLook.on(StageColors.now());
        work.begin(
                told -> {
                    List<SignMap> maps = subject.methods().stream().map(subject::map).toList();
                    BufferedImage picture = new SignSheet(maps, language, look).image();
                    return () -> show(picture, maps, language);
                },
                () -> {},
                onFailure::accept);
    }

    /**
     * Opens a window with the maps of a topic.
     *
     * @param from where the window belongs to
     * @param topic one that has such
     */
    public static void open(
            Component from, String topic, Language language, Consumer<Throwable> onFailure) {
        Optional<SignSubject> subject = SignMaps.ofTopic(topic);
        subject.ifPresent(
                asked ->
                        new SignWindow(
                                        SwingUtilities.getWindowAncestor(from),
                                        asked,
                                        language,
                                        onFailure)
                                .setVisible(true));
    }

    private void show(BufferedImage picture, List<SignMap> maps, Language language) {
        sheet.show(picture, words(maps, language));
        int bar = ((JScrollPane) getContentPane()).getVerticalScrollBar().getPreferredSize().width;
        pack();
        if (getHeight() > MOST_HIGH) setSize(getWidth() + bar, MOST_HIGH);
        setLocationRelativeTo(getOwner());
    }

    /** The picture in words, for those who do not see it. */
    private static String words(List<SignMap> maps, Language language) {
        var words = new SignWords(language);
        return maps.stream()
                .map(map -> map.method() + ": " + words.share(map))
                .collect(Collectors.joining("; "));
    }

    @Override
    public void dispose() {
        work.close();
        super.dispose();
    }

    /** The picture, as soon as there is one. */
    private static final class Sheet extends JPanel {
        private static final long serialVersionUID = 1L;

        private transient Optional<BufferedImage> picture = Optional.empty();

        Sheet() {
            setFocusable(true);
            setPreferredSize(new Dimension(SignSheet.WIDTH, FIRST_HIGH));
        }

        void show(BufferedImage made, String words) {
            picture = Optional.of(made);
            setPreferredSize(new Dimension(made.getWidth(), made.getHeight()));
            getAccessibleContext().setAccessibleName(words);
            revalidate();
            repaint();
        }

        @Override
        protected void paintComponent(Graphics g) {
            super.paintComponent(g);
            picture.ifPresent(made -> g.drawImage(made, 0, 0, this));
        }
    }
}
