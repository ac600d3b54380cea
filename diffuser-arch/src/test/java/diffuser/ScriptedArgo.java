package diffuser;

import jason.Argo;

import javino.board.BoardConfig;
import javino.link.LinkOpener;

/** An Argo whose ports are fake boards, as those of {@link ScriptedDiffuser} are. */
public class ScriptedArgo extends Argo {

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
