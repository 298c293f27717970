package rasterlab.app.canvas.file;

import java.awt.event.ActionEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import javax.swing.filechooser.FileNameExtensionFilter;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;

/**
 * Asks for the file of a picture, first in the form that was chosen last; the chosen filter gives
 * an ending to a name that has none.
 */
class PictureChooser extends SaveChooser {
    private static final long serialVersionUID = 1L;

    PictureChooser(Language language) {
        super(language, file -> file);
        offerForms(language);
    }

    /**
     * @param mayReplace asked before a file that is there is written over
     */
    PictureChooser(Language language, Predicate<Path> mayReplace) {
        super(language, file -> file, mayReplace);
        offerForms(language);
    }

    private void offerForms(Language language) {
        Texts texts = Texts.of("canvas", language);
        setDialogTitle(texts.text("picture.title"));
        setAcceptAllFileFilterUsed(false);
        for (PictureForm form : PictureForm.values())
            addChoosableFileFilter(
                    new FileNameExtensionFilter(
                            texts.text("picture." + form.ending()), form.ending()));
        setFileFilter(getChoosableFileFilters()[LastChosen.now().form().ordinal()]);
        addActionListener(this::keepForm);
    }

    private void keepForm(ActionEvent e) {
        if (e.getActionCommand().equals(APPROVE_SELECTION))
            LastChosen.now().as(PictureForm.of(named(chosen()))).remember();
    }

    /**
     * @throws Complaint if the chosen file has the ending of something else
     */
    @Override
    protected Path named(Path chosen) {
        int filter = List.of(getChoosableFileFilters()).indexOf(getFileFilter());
        Path file = PictureForm.values()[filter].named(chosen);
        PictureForm.of(file);
        return file;
    }
}
