package diffuser;

import jason.Difuser;

import javino.board.BoardConfig;
import javino.link.LinkOpener;

/** The public Difuser, which is an Argo too; its ports are fake boards, as those of {@link ScriptedDiffuser} are. */
public class ScriptedArgo extends Difuser {

    private static final long serialVersionUID = 1L;

    @Override
    protected LinkOpener link(String port) {
        return ScriptedDiffuser.linkTo(port);
    }

    @Override
    protected BoardConfig boardConfig() {
        return ScriptedDiffuser.quick();
    }
}
