package rasterlab.app.canvas;

import java.io.File;
import javax.swing.JFileChooser;
import javax.swing.UIManager;

/** Asks for a file, first in the folder where one was chosen last. */
public class LastFolderChooser extends JFileChooser {
    private static final long serialVersionUID = 1L;

    private static final String FOLDER = "Rasterlab.lastFolder";

    public LastFolderChooser() {
        super((File) UIManager.get(FOLDER));
    }

    @Override
    public void approveSelection() {
        UIManager.put(FOLDER, getSelectedFile().getAbsoluteFile().getParentFile());
        super.approveSelection();
    }
}
