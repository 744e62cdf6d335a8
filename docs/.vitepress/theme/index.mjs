import DefaultTheme from 'vitepress/theme'
import PlaneFigure from './PlaneFigure.vue'
import PlayPage from './PlayPage.vue'
import './style.css'

export default {
  extends: DefaultTheme,
  enhanceApp({ app }) {
    app.component('PlaneFigure', PlaneFigure)
    app.component('PlayPage', PlayPage)
  },
}
